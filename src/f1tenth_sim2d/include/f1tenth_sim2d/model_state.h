#pragma once

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// A model of the world as it stands or moves now; pose and velocity are those of the model's frame, in the world.
struct ModelState
{
  Pose2 pose;
  Vec2 velocity;         ///< m/s
  double yaw_rate{0.0};  ///< rad/s
};
}  // namespace f1tenth_sim2d
