#pragma once

#include <cmath>

/// Geometry of the plane: m, rad, REP-103 axes.
namespace move_base
{
struct Vec2
{
  double x{0.0};
  double y{0.0};
};

struct Pose2
{
  double x{0.0};
  double y{0.0};
  double yaw{0.0};

  Vec2 position() const { return {x, y}; }
};

inline Vec2 operator+(const Vec2 & a, const Vec2 & b)
{
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(const Vec2 & a, const Vec2 & b)
{
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator*(double factor, const Vec2 & a)
{
  return {factor * a.x, factor * a.y};
}
inline double dot(const Vec2 & a, const Vec2 & b)
{
  return a.x * b.x + a.y * b.y;
}
inline double cross(const Vec2 & a, const Vec2 & b)
{
  return a.x * b.y - a.y * b.x;
}
inline double norm(const Vec2 & a)
{
  return std::hypot(a.x, a.y);
}
inline double distance(const Vec2 & a, const Vec2 & b)
{
  return norm(b - a);
}
inline double distance(const Pose2 & a, const Pose2 & b)
{
  return distance(a.position(), b.position());
}

/// The same angle in (-pi, pi].
double normalizeAngle(double angle);

/// A point given in the frame of pose, in the frame in which pose is given.
Vec2 transform(const Pose2 & pose, const Vec2 & point);

/// A pose given in the frame of pose, in the frame in which pose is given.
Pose2 compose(const Pose2 & pose, const Pose2 & relative);

Pose2 inverse(const Pose2 & pose);

/// Where a car is after driving an arc.
/// @param length     m along the arc, negative backwards
/// @param curvature  1/m, of the wheels' setting: positive is steering to the left
Pose2 advance(const Pose2 & pose, double length, double curvature);
}  // namespace move_base
