#pragma once

#include <move_base/global_planner.h>
#include <move_base/map/costmap.h>
#include "control/path_follower.h"
#include "control/racer_options.h"
#include "path/goals.h"
#include "path/terms.h"

namespace f1tenth_racer
{
/// What a navigator asks of the planner for the goals that it pursues.
class PlanRequests
{
public:
  PlanRequests(const RacerOptions & options, const Goals & goals, const PathFollower & follower)
  : options_(options), goals_(goals), follower_(follower)
  {
  }

  /// Whether the goal is passed at speed.
  bool passes() const { return options_.free_goal_vel && goals_.anyNext(); }
  const GoalTolerance & tolerance() const { return passes() ? options_.via_tolerance : options_.goal_tolerance; }

  /// @param time_needed  s, that the plan may take while the car drives on; 0: none
  /// @param way          what the car drives along until then
  PlanRequest from(const CarState & car, double time_needed, const PathFollower & way) const;
  PlanRequest from(const CarState & car, double time_needed) const { return from(car, time_needed, follower_); }
  /// Whether a car can switch to a plan. A car that is too fast for it, would have to turn round, or has left the way
  /// on which the plan begins, brakes along the old one first.
  bool canDrive(const Plan & plan, const CarState & car, const Costmap & costmap) const;
  /// Whether a car that is still so far from its goal, m along the way, may drive a race line.
  bool isFar(double way, double speed, double time_needed) const;

private:
  double leadTime(double time_needed) const;
  bool races(const CarState & car, double time_needed) const;
  double approachLength(double speed, double time_needed) const;
  double extensionLength() const;

  const RacerOptions & options_;
  const Goals & goals_;
  const PathFollower & follower_;
};
}  // namespace f1tenth_racer
