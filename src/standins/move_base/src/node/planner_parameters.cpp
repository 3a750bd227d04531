#include "move_base/planner_parameters.h"

#include <workspace_support/option_checks.h>

#include <algorithm>

namespace move_base
{
PlannerOptions readWayPlanner(const PlannerSetup & setup)
{
  PlannerOptions planner;
  const auto read = [&](const std::string & owner, const std::string & name, auto & value) {
    setup.parameters.read(ofPlanner(owner, name), value);
  };
  read(setup.global_planner, "allow_reversing", planner.allow_reversing);
  read(setup.global_planner, "reverse_penalty", planner.reverse_penalty);
  read(setup.global_planner, "direction_penalty", planner.direction_penalty);
  read(setup.global_planner, "steering_penalty", planner.steering_penalty);
  read(setup.global_planner, "curvature_penalty", planner.curvature_penalty);
  read(setup.global_planner, "max_expansions", planner.max_expansions);
  read(setup.local_planner, "min_turning_radius", planner.min_turning_radius);
  read(setup.local_planner, "min_obstacle_dist", planner.min_obstacle_dist);
  return planner;
}

void readSteering(const PlannerSetup & setup, double & wheelbase, double & max_steering_angle)
{
  double radius = PlannerOptions{}.min_turning_radius;
  setup.parameters.read(ofPlanner(setup.local_planner, "wheelbase"), wheelbase);
  setup.parameters.read(ofPlanner(setup.local_planner, "min_turning_radius"), radius);
  if (!setup.parameters.read(ofPlanner(setup.local_planner, "max_steering_angle"), max_steering_angle)) {
    max_steering_angle = std::max(max_steering_angle, maths::atan(wheelbase / radius));
  }
  const double least = wheelbase / maths::tan(max_steering_angle);
  setup.parameters.check([&] {
    requireOption(
      radius >= least, "min_turning_radius", radius,
      "at least wheelbase / tan(max_steering_angle) = " + std::to_string(least));
  });
}
}  // namespace move_base
