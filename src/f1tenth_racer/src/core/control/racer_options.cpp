#include "control/racer_options.h"

#include <workspace_support/option_checks.h>

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
  planner.requireSteering(follower.limits.wheelbase, follower.limits.max_steering_angle);
}
}  // namespace f1tenth_racer
