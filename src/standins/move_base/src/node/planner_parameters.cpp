#include "move_base/planner_parameters.h"

#include <ros/console.h>

#include <algorithm>
#include <optional>

namespace move_base
{
PlannerOptions readWayPlanner(const PlannerSetup & setup)
{
  PlannerOptions planner;
  const auto read = [&](const std::string & owner, const std::string & name, auto & value) {
    setup.parameters.read(ofPlanner(owner, name), value);
  };
  read(setup.global_planner, "allow_reversing", planner.allow_reversing);
  read(setup.global_planner, "max_expansions", planner.max_expansions);
  read(setup.local_planner, "min_turning_radius", planner.min_turning_radius);
  read(setup.local_planner, "min_obstacle_dist", planner.min_obstacle_dist);
  return planner;
}

void readSpeeds(const PlannerSetup & setup, double & max_vel_x, double & min_vel_x)
{
  std::optional<double> told;
  setup.parameters.read(ofPlanner(setup.local_planner, "max_vel_x"), max_vel_x);
  setup.parameters.read(ofPlanner(setup.local_planner, "min_vel_x"), told);
  if (told && *told > 0.0) {
    min_vel_x = *told;
    return;
  }
  min_vel_x = std::min(min_vel_x, max_vel_x);
  if (told) {
    ROS_WARN("%s: min_vel_x is %g, the least speed is %g m/s", setup.local_planner.c_str(), *told, min_vel_x);
  }
}

void readSteering(const PlannerSetup & setup, double & wheelbase, double & max_steering_angle)
{
  PlannerOptions planner;
  setup.parameters.read(ofPlanner(setup.local_planner, "wheelbase"), wheelbase);
  setup.parameters.read(ofPlanner(setup.local_planner, "min_turning_radius"), planner.min_turning_radius);
  if (!setup.parameters.read(ofPlanner(setup.local_planner, "max_steering_angle"), max_steering_angle)) {
    max_steering_angle = std::max(max_steering_angle, maths::atan(wheelbase / planner.min_turning_radius));
  }
  setup.parameters.check([&] { planner.requireSteering(wheelbase, max_steering_angle); });
}
}  // namespace move_base
