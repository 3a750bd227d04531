#pragma once

#include "f1tenth_sim2d/geometry.h"

/// What a driver asks a car for.
namespace f1tenth_sim2d
{
struct DriveCommand
{
  double speed{0.0};           ///< m/s
  double steering_angle{0.0};  ///< rad
};

struct TwistCommand
{
  Vec2 velocity;         ///< m/s, in the frame of the car; y is for planar drives only
  double yaw_rate{0.0};  ///< rad/s
};
}  // namespace f1tenth_sim2d
