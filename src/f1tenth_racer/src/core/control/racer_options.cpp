#include "control/racer_options.h"

namespace f1tenth_racer
{
void RacerOptions::validate() const
{
  checkEach(*this);
  planner.validate();
  follower.validate();
  planner.requireSteering(follower.limits.wheelbase, follower.limits.max_steering_angle);
}
}  // namespace f1tenth_racer
