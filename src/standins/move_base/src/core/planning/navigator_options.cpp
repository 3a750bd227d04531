#include "move_base/planning/navigator_options.h"

#include <workspace_support/option_checks.h>

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
  requirePositive("max_vel_x_backwards", backing_speed);
}
}  // namespace move_base
