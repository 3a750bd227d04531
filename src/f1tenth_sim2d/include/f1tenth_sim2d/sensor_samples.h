#pragma once

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Wheel odometry: dead reckoning from noisy speed and steering, from the spawn pose.
struct WheelOdometry
{
  Pose2 pose;
  double speed{0.0};          ///< m/s, along the car
  double yaw_rate{0.0};       ///< rad/s
  double lateral_speed{0.0};  ///< m/s, to the left; of a planar drive only
};

/// Without the turn of the sensor on the car, which ImuDescription::pose tells.
struct ImuSample
{
  double yaw{0.0};       ///< rad
  double yaw_rate{0.0};  ///< rad/s
  Vec2 acceleration;     ///< m/s^2, in the frame of the car; z is gravity
};
}  // namespace f1tenth_sim2d
