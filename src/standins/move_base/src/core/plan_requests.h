#pragma once

#include "control/path_follower.h"
#include "goals.h"
#include "map/costmap.h"
#include "navigator_options.h"
#include "path/global_planner.h"

namespace move_base
{
/// What a navigator asks of the planner for the goals that it pursues.
class PlanRequests
{
public:
  PlanRequests(const NavigatorOptions & options, const Goals & goals, const PathFollower & follower)
  : options_(options), goals_(goals), follower_(follower)
  {
  }

  /// Whether the goal is passed at speed.
  bool passes() const { return options_.free_goal_vel && goals_.anyNext(); }
  const GoalTolerance & tolerance() const { return passes() ? options_.via_tolerance : options_.goal_tolerance; }

  /// @param time_needed  s, that the plan may take while the car drives on; 0: none
  PlanRequest from(const CarState & car, double time_needed) const;
  /// How long the car may drive on along the path that it has until the plan is there, s.
  double leadTime(double time_needed) const;
  /// Whether a car can switch to a plan. A car that is too fast for it, would have to turn round, or has left the way
  /// on which the plan begins, brakes along the old one first.
  bool canDrive(const Plan & plan, const CarState & car, const Costmap & costmap) const;
  /// Whether a car that is still so far from its goal, m along the way, may drive a race line.
  bool isFar(double way, double speed, double time_needed) const;

private:
  bool races(const CarState & car, double time_needed) const;
  double approachLength(double speed, double time_needed) const;
  double extensionLength() const;

  const NavigatorOptions & options_;
  const Goals & goals_;
  const PathFollower & follower_;
};
}  // namespace move_base
