#pragma once

#include <array>

#include "amcl/geometry.h"

namespace amcl
{
/// A pose in the map frame and how certain it is: variances of x (m^2), y (m^2) and yaw (rad^2), row by row.
struct Estimate
{
  Pose2 pose;
  std::array<double, 9> covariance{};  ///< symmetric

  /// @throws Error that says what is not finite, or that such a covariance is impossible
  void validate() const;
};
}  // namespace amcl
