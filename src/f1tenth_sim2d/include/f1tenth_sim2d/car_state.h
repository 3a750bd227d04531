#pragma once

#include <array>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// True state of a car. Pose and velocity are those of its own frame, on the ground below the middle of the rear axle. Where
/// base_footprint is in that frame, which need not be there, CarDescription::base_frame_pose says.
struct CarState
{
  Pose2 pose;                            ///< in the world
  Vec2 velocity;                         ///< m/s, in the frame of the car
  double yaw_rate{0.0};                  ///< rad/s
  Vec2 acceleration;                     ///< m/s^2, of the centre of mass, in the frame of the car
  double steering_angle{0.0};            ///< rad, of the single-track front wheel
  std::array<double, 4> wheel_angles{};  ///< rad: front left, front right, rear left, rear right
  std::array<double, 4> wheel_speeds{};  ///< rad/s, same order
};
}  // namespace f1tenth_sim2d
