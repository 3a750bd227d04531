#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

#include "core/models/tyre.h"
#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// How the wheels of an axle meet the ground, and what it does to them.
struct WheelFooting
{
  static constexpr double kSlipSpeedMin = 0.1;  ///< m/s, least speed that slip is relative to, as in CommonRoad

  double along;  ///< m/s, of the axle, where the wheels point
  double aside;  ///< m/s, to their left
  TyreForces forces;

  /// @param velocity  of the axle, m/s, in the frame of the car
  /// @param steering  of the angle of the wheels
  WheelFooting(const Vec2 & velocity, const maths::SineCosine & steering)
  : along(velocity.x * steering.cosine + velocity.y * steering.sine),
    aside(velocity.y * steering.cosine - velocity.x * steering.sine)
  {
  }

  double angle() const { return maths::atan2(aside, std::abs(along)); }
  double slipSpeed() const { return std::max(std::abs(along), kSlipSpeedMin); }
  /// @param circumference  m/s
  double slip(double circumference) const { return (circumference - along) / slipSpeed(); }

  /// N s/m, by which the tyres push more when their circumference turns faster.
  double alongDamping() const { return std::max(forces.along.slope, 0.0) / slipSpeed(); }
  /// N s/m, by which they hold more when they go faster to the side.
  double asideDamping() const
  {
    const double squared = std::max(along * along + aside * aside, kSlipSpeedMin * kSlipSpeedMin);
    return std::max(-forces.aside.slope, 0.0) * std::abs(along) / squared;
  }
};
}  // namespace f1tenth_sim2d
