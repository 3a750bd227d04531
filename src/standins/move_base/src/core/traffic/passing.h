#pragma once

#include <optional>
#include <vector>

#include "path/global_planner.h"
#include "path/speed_profile.h"
#include "traffic/forecast.h"

namespace move_base
{
/// What a way past others is looked for with.
struct PassingRequest
{
  const Costmap & costmap;
  const PlannerOptions & planner;
  const SpeedLimits & limits;
  const Plan & plan;            ///< that the car is driving
  const PlanRequest & request;  ///< for its goal, with the race line's options and a lead on the plan's path
  const std::vector<Forecast> & others;
  double s{0.0};      ///< m, the car's place on the plan's path
  double speed{0.0};  ///< m/s, of the car
};

/// The same plan with its line moved to one side of others, wherever the car is going to be beside them: the timing
/// follows from the speed profile of the line, and the line from the timing, in turns. Past them, where there is room
/// beside them all the time; or else it stays beside them while the car falls behind. Nothing if neither goes.
std::optional<Plan> planPast(const PassingRequest & request);
}  // namespace move_base
