#pragma once

#include <workspace_support/parameter_reader.h>

#include <string>
#include <vector>

#include "move_base/global_planner.h"

namespace move_base
{
/// Where a planner's parameter is: in its namespace, as for the original, or, for short, right under the node.
inline std::vector<std::string> ofPlanner(const std::string & planner, const std::string & name)
{
  return {planner + "/" + name, name};
}

/// The parameters of WayPlanner, in part those of the local planner.
/// @throws OptionError
PlannerOptions readWayPlanner(const PlannerSetup & setup);

/// Reads max_vel_x and min_vel_x, m/s, of the local planner. A least speed of 0 or less, which the original allows, leaves
/// the planner's own, which is no more than max_vel_x.
/// @throws OptionError
void readSpeeds(const PlannerSetup & setup, double & max_vel_x, double & min_vel_x);

/// Reads wheelbase and max_steering_angle of the local planner: without the latter what min_turning_radius needs, as the
/// original has the radius only.
/// @throws OptionError
void readSteering(const PlannerSetup & setup, double & wheelbase, double & max_steering_angle);
}  // namespace move_base
