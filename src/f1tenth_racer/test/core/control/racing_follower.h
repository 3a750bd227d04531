#pragma once

#include "control/path_follower.h"
#include "roads.h"

namespace f1tenth_racer::testing
{
inline constexpr double kStepTime = 0.025;  // s

inline FollowerOptions racingFollower()
{
  FollowerOptions options;
  options.limits.max_vel_x = 4.0;
  options.limits.max_vel_x_backwards = 0.5;
  options.limits.max_vel_theta = 5.0;
  options.limits.acc_lim_x = 3.0;
  options.limits.dec_lim_x = 3.0;
  return options;
}
}  // namespace f1tenth_racer::testing
