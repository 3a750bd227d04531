#include "racer_parameters.h"

#include <move_base/planner_parameters.h>

namespace f1tenth_racer
{
RacerOptions readRacer(const PlannerSetup & setup)
{
  RacerOptions options;
  SpeedLimits & limits = options.follower.limits;
  setup.parameters.read(ofPlanner(setup.local_planner, "acc_lim_x"), limits.dec_lim_x);
  const double own_least_speed = limits.min_vel_x;
  RacerOptions::visitEach(options, [&](const Option & option, auto & value) {
    setup.parameters.read(ofPlanner(setup.local_planner, option.name), value);
  });
  // Those in which files for the original planners differ.
  limits.min_vel_x = own_least_speed;
  readSpeeds(setup, limits.max_vel_x, limits.min_vel_x);
  readSteering(setup, limits.wheelbase, limits.max_steering_angle);
  options.planner = readWayPlanner(setup);
  setup.parameters.check([&] { options.validate(); });
  return options;
}
}  // namespace f1tenth_racer
