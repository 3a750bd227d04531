#pragma once

#include <cmath>

namespace f1tenth_sim2d
{
constexpr double kRoughAngleError = 1e-7;  // rad

/// atan2(y, x) to within kRoughAngleError, without a branch: Abramowitz and Stegun, 4.4.49, error below 2e-8.
/// Not a number for the origin.
inline double roughAngle(double y, double x)
{
  const double across = std::abs(x);
  const double up = std::abs(y);
  const bool is_steep = up > across;
  const double t = (is_steep ? across : up) / (is_steep ? up : across);
  const double u = t * t;
  double series = 0.0028662257;
  series = series * u - 0.0161657367;
  series = series * u + 0.0429096138;
  series = series * u - 0.0752896400;
  series = series * u + 0.1065626393;
  series = series * u - 0.1420889944;
  series = series * u + 0.1999355085;
  series = series * u - 0.3333314528;
  const double octant = t * (series * u + 1.0);
  const double quadrant = is_steep ? 0.5 * M_PI - octant : octant;
  return std::copysign(x < 0.0 ? M_PI - quadrant : quadrant, y);
}
}  // namespace f1tenth_sim2d
