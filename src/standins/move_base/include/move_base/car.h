#pragma once

#include <cmath>

#include "move_base/map/geometry.h"

namespace move_base
{
inline constexpr double kStandingSpeed = 0.05;  // m/s, below it a car stands

/// A car's motion, in the map.
struct CarState
{
  Pose2 pose;
  double speed{0.0};     ///< m/s, negative backwards
  double yaw_rate{0.0};  ///< rad/s

  bool stands() const { return std::abs(speed) < kStandingSpeed; }
};

/// What was known of a car's motion, and since when.
struct CarSighting
{
  CarState car;
  double seen{0.0};      ///< s, when it was at its pose
  double measured{0.0};  ///< s, when it had its speed
};

struct DriveCommand
{
  double speed{0.0};      ///< m/s, negative backwards
  double curvature{0.0};  ///< 1/m, positive is steering to the left

  double yawRate() const { return speed * curvature; }
  /// rad, of the wheels; straight for a car that stops.
  /// @param wheelbase  m
  double steeringAngle(double wheelbase) const { return speed == 0.0 ? 0.0 : maths::atan(wheelbase * curvature); }
};
}  // namespace move_base
