#pragma once

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Pose of a car's centre of mass and its velocity in the world, m/s and rad/s.
struct PlanarMotion
{
  Pose2 pose;
  Vec2 velocity;
  double yaw_rate{0.0};
};

/// What became of a car that touched something in a step.
struct ContactEffect
{
  Pose2 displacement;           ///< m, rad: how far the car went in the step, contacts included
  Vec2 velocity_change;         ///< m/s, by contacts alone
  double yaw_rate_change{0.0};  ///< rad/s, by contacts alone
};
}  // namespace f1tenth_sim2d
