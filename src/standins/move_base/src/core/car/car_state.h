#pragma once

#include <cmath>

#include "geometry/geometry.h"

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
}  // namespace move_base
