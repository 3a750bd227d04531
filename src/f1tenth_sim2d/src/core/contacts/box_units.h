#pragma once

#include <box2d/box2d.h>

#include "f1tenth_sim2d/geometry.h"

/// Box2D works in decimetres here. Its tolerances are lengths compiled into the library, meant for bodies of 0.1 to
/// 10 units: it leaves bodies 0.005 units inside each other and treats approaching slower than 1 unit/s as resting.
/// In metres a bumper that stands out by 5 mm would sink in up to the chassis; in decimetres it sinks in by 0.5 mm.
namespace f1tenth_sim2d
{
constexpr double kBoxUnitsPerMetre = 10.0;

inline float toBox(double metres)
{
  return static_cast<float>(metres * kBoxUnitsPerMetre);
}
inline b2Vec2 toBox(const Vec2 & v)
{
  return {toBox(v.x), toBox(v.y)};
}
inline double fromBox(float units)
{
  return static_cast<double>(units) / kBoxUnitsPerMetre;
}
inline Vec2 fromBox(const b2Vec2 & v)
{
  return {fromBox(v.x), fromBox(v.y)};
}

/// Moments of inertia (kg m^2) and torques (N m) scale with the square of the length.
inline float toBoxSquared(double value)
{
  return static_cast<float>(value * kBoxUnitsPerMetre * kBoxUnitsPerMetre);
}
}  // namespace f1tenth_sim2d
