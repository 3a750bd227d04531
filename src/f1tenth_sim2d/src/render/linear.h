#pragma once

#include <array>
#include <cmath>

#include "f1tenth_sim2d/geometry.h"

/// Vectors and rigid transforms of double that are made of additions and multiplications in a fixed order: Eigen's
/// products take other instructions, and other roundings, on other processors.
namespace f1tenth_sim2d
{
struct Vec3
{
  double x{0.0};
  double y{0.0};
  double z{0.0};
};

inline Vec3 operator+(const Vec3 & a, const Vec3 & b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(const Vec3 & a, const Vec3 & b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(double factor, const Vec3 & a)
{
  return {factor * a.x, factor * a.y, factor * a.z};
}
inline double dot(const Vec3 & a, const Vec3 & b)
{
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
/// cross(b, a) is exactly -cross(a, b).
inline Vec3 cross(const Vec3 & a, const Vec3 & b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3 & a)
{
  return std::sqrt(dot(a, a));
}
/// The zero vector stays what it is.
inline Vec3 normalized(const Vec3 & a)
{
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : a;
}
inline Vec3 toVec3(const Eigen::Vector3d & a)
{
  return {a.x(), a.y(), a.z()};
}

/// A linear map and an offset.
struct Transform
{
  std::array<Vec3, 3> rows{Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}, Vec3{0.0, 0.0, 1.0}};
  Vec3 offset;

  Vec3 turned(const Vec3 & direction) const
  {
    return {dot(rows[0], direction), dot(rows[1], direction), dot(rows[2], direction)};
  }
  /// The inverse of turned() for a rotation.
  Vec3 turnedBack(const Vec3 & direction) const
  {
    return (direction.x * rows[0] + direction.y * rows[1]) + direction.z * rows[2];
  }
  Vec3 operator()(const Vec3 & point) const { return turned(point) + offset; }
};

/// First b, then a.
inline Transform operator*(const Transform & a, const Transform & b)
{
  Transform product;
  for (std::size_t i = 0; i < 3; ++i) {
    product.rows[i] = b.turnedBack(a.rows[i]);
  }
  product.offset = a(b.offset);
  return product;
}

/// The inverse of a rotation and an offset.
inline Transform inverseOf(const Transform & a)
{
  Transform inverse;
  inverse.rows = {
    Vec3{a.rows[0].x, a.rows[1].x, a.rows[2].x}, Vec3{a.rows[0].y, a.rows[1].y, a.rows[2].y},
    Vec3{a.rows[0].z, a.rows[1].z, a.rows[2].z}};
  inverse.offset = -1.0 * inverse.turned(a.offset);
  return inverse;
}

inline Transform toTransform(const Pose3 & pose)
{
  const auto & q = pose.rotation;
  const double w = q.w();
  const double x = q.x();
  const double y = q.y();
  const double z = q.z();
  Transform transform;
  transform.rows = {
    Vec3{1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
    Vec3{2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)},
    Vec3{2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)}};
  transform.offset = toVec3(pose.position);
  return transform;
}
}  // namespace f1tenth_sim2d
