#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <move_base/control/navigator.h>
#include "control/racer.h"
#include "kinematic_car.h"
#include "line/race_line_planner.h"
#include "roads.h"

namespace f1tenth_racer::testing
{

constexpr double kCycle = 0.05;  // s

struct JourneyOptions : NavigatorOptions, RacerOptions
{
};

inline JourneyOptions racingJourney()
{
  JourneyOptions options;
  options.follower.limits.max_vel_x = 3.0;
  options.follower.limits.max_vel_x_backwards = 0.5;
  options.follower.limits.max_vel_theta = 4.0;
  options.follower.limits.acc_lim_x = 3.0;
  options.follower.limits.dec_lim_x = 3.0;
  options.planner_patience = 1.0;
  options.controller_patience = 2.0;
  options.backing_speed = 0.5;
  return options;
}

// The navigator of move_base with both planners of the racer.
class RacingNavigator : public Navigator
{
public:
  explicit RacingNavigator(const JourneyOptions & options, PlanWorker worker = {})
  : Navigator(
      options, std::make_unique<RaceLinePlanner>(options.planner), std::make_unique<Racer>(options), std::move(worker))
  {
  }
};

// A car that drives where a navigator takes it.
class Journey
{
public:
  Journey(const JourneyOptions & options, Costmap costmap, const Pose2 & start, PlanWorker worker = {})
  : navigator(options, std::move(worker)), costmap_(std::move(costmap)), car(start)
  {
  }

  CycleOutput cycle()
  {
    if (scan) {
      navigator.observe(*scan, costmap_);
    }
    seen.push_front(car.state());
    const std::size_t late = std::min(delay, seen.size() - 1);
    CycleOutput output =
      navigator.cycle({time, seen[late], sensors_current, kCycle * static_cast<double>(late)}, costmap_);
    if (wheels_grip) {
      car.drive(output.command.value_or(DriveCommand{}), kCycle);
    }
    if (output.recovery) {
      recoveries.push_back(output.recovery->name);
    }
    if (output.command) {
      command = *output.command;
    }
    clearance = std::min(clearance, costmap_.clearance(car.state().pose));
    time += kCycle;
    return output;
  }

  Outcome untilOutcome(double limit = 60.0)
  {
    for (const double end = time + limit; time < end;) {
      if (const auto outcome = cycle().outcome) {
        return *outcome;
      }
    }
    return {false, "nothing within the limit"};
  }

  Costmap & costmap() { return costmap_; }

  RacingNavigator navigator;
  double time{10.0};
  bool sensors_current{true};
  bool wheels_grip{true};
  std::optional<LaserScan> scan;  // seen in each cycle
  std::size_t delay{0};           // cycles until the navigator sees where the car is
  std::deque<CarState> seen;
  double clearance{HUGE_VAL};
  DriveCommand command;
  std::vector<std::string> recoveries;

private:
  Costmap costmap_;

public:
  KinematicCar car;
};
}  // namespace f1tenth_racer::testing
