#include "navigator_options.h"

#include <workspace_support/option_checks.h>

#include <cmath>
#include <string>

namespace move_base
{
void NavigatorOptions::validate() const
{
  requireNotNegative("planner_frequency", planner_frequency);
  requireNotNegative("planner_patience", planner_patience);
  requireNotNegative("controller_patience", controller_patience);
  requireOption(max_planning_retries >= -1, "max_planning_retries", max_planning_retries, "at least -1");
  requireNotNegative("oscillation_timeout", oscillation_timeout);
  requireNotNegative("oscillation_distance", oscillation_distance);
  requirePositive("xy_goal_tolerance", goal_tolerance.distance);
  requirePositive("yaw_goal_tolerance", goal_tolerance.yaw);
  requirePositive("via_xy_tolerance", via_tolerance.distance);
  requirePositive("via_yaw_tolerance", via_tolerance.yaw);
  requireNotNegative("coast_time", coast_time);
  planner.validate();
  follower.validate();
  const double least = follower.limits.wheelbase / std::tan(follower.limits.max_steering_angle);
  requireOption(
    planner.min_turning_radius >= least, "min_turning_radius", planner.min_turning_radius,
    "at least wheelbase / tan(max_steering_angle) = " + std::to_string(least));
}
}  // namespace move_base
