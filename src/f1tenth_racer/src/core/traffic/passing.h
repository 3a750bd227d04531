#pragma once

#include <optional>
#include <vector>

#include <move_base/car.h>
#include <move_base/planning/way_planner.h>
#include "options/traffic_options.h"
#include "path/terms.h"
#include "speed/speed_profile.h"
#include "traffic/forecast.h"

namespace f1tenth_racer
{
/// Inputs of the search for a way past others.
struct PassingRequest
{
  const Costmap & costmap;
  const PlannerOptions & planner;
  const SpeedLimits & limits;
  const Plan & plan;            ///< that the car is driving
  const PlanRequest & request;  ///< for its goal, with the race line's options and a lead on the plan's path
  const std::vector<Forecast> & others;
  double s;  ///< m, the car's place on the plan's path
  const CarState & car;
  TrafficOptions traffic{};
};

/// A plan that leads past others, and how it is to be driven.
struct PassingPlan
{
  Plan plan;
  Caution caution;
};

/// The same plan with its line moved to one side of others, wherever the car is going to be beside them: the timing
/// follows from the speed profile of the line, and the line from the timing, in turns. Past them, where there is room
/// beside them all the time; or else out to their side, at their pace. A car that is already beside them falls back, or
/// goes on, if need be with the goal farther to the side than wanted. Nothing if none of this works.
std::optional<PassingPlan> planPast(const PassingRequest & request);
}  // namespace f1tenth_racer
