#include "control/racer_options.h"

#include <workspace_support/option_checks.h>

#include <string>

namespace f1tenth_racer
{
void RacerOptions::validate() const
{
  requirePositive("xy_goal_tolerance", goal_tolerance.distance);
  requirePositive("yaw_goal_tolerance", goal_tolerance.yaw);
  requirePositive("via_xy_tolerance", via_tolerance.distance);
  requirePositive("via_yaw_tolerance", via_tolerance.yaw);
  requireNotNegative("coast_time", coast_time);
  planner.validate();
  follower.validate();
  const double least = follower.limits.wheelbase / maths::tan(follower.limits.max_steering_angle);
  requireOption(
    planner.min_turning_radius >= least, "min_turning_radius", planner.min_turning_radius,
    "at least wheelbase / tan(max_steering_angle) = " + std::to_string(least));
}
}  // namespace f1tenth_racer
