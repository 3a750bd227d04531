#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

/// Geometry of the plane: m, rad, REP-103 axes.
namespace workspace_support
{
/// A point or vector, m (or m/s).
struct Vec2
{
  double x{0.0};
  double y{0.0};
};

/// Position, m, and yaw, rad, counter-clockwise.
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
  return maths::hypot(a.x, a.y);
}
inline double distance(const Vec2 & a, const Vec2 & b)
{
  return norm(b - a);
}
inline double distance(const Pose2 & a, const Pose2 & b)
{
  return distance(a.position(), b.position());
}

/// The equivalent angle in [-pi, pi].
inline double normalizeAngle(double angle)
{
  return std::remainder(angle, 2.0 * M_PI);
}

/// A point given in the frame of pose, in the frame in which pose is given.
inline Vec2 transform(const Pose2 & pose, const Vec2 & point)
{
  const double c = maths::cos(pose.yaw);
  const double s = maths::sin(pose.yaw);
  return {pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y};
}

/// The velocity of a point of a body that moves and turns.
/// @param velocity  m/s, of the point of the body from which arm, m, leads to the other one, in the same frame
inline Vec2 velocityAt(const Vec2 & velocity, double yaw_rate, const Vec2 & arm)
{
  return {velocity.x - yaw_rate * arm.y, velocity.y + yaw_rate * arm.x};
}

/// A pose given in the frame of pose, in the frame in which pose is given.
inline Pose2 compose(const Pose2 & pose, const Pose2 & relative)
{
  const Vec2 position = transform(pose, relative.position());
  return {position.x, position.y, normalizeAngle(pose.yaw + relative.yaw)};
}

inline Pose2 inverse(const Pose2 & pose)
{
  const Vec2 position = transform({0.0, 0.0, -pose.yaw}, {-pose.x, -pose.y});
  return {position.x, position.y, -pose.yaw};
}
}  // namespace workspace_support
