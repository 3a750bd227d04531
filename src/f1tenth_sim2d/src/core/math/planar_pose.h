#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
using workspace_support::normalizeAngle;

inline double length(const Vec2 & v)
{
  return std::sqrt(v.x * v.x + v.y * v.y);
}

/// A pose with its sine and cosine at hand.
struct Transform2
{
  double x{0.0};
  double y{0.0};
  double cosine{1.0};
  double sine{0.0};

  Transform2() = default;
  explicit Transform2(const Pose2 & pose) : Transform2(pose, maths::sineCosine(pose.yaw)) {}

  Vec2 rotate(const Vec2 & v) const { return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y}; }
  Vec2 rotateBack(const Vec2 & v) const { return {cosine * v.x + sine * v.y, cosine * v.y - sine * v.x}; }
  Vec2 apply(const Vec2 & p) const
  {
    const Vec2 r = rotate(p);
    return {x + r.x, y + r.y};
  }
  Vec2 applyBack(const Vec2 & p) const { return rotateBack({p.x - x, p.y - y}); }

private:
  Transform2(const Pose2 & pose, const maths::SineCosine & yaw)
  : x(pose.x), y(pose.y), cosine(yaw.cosine), sine(yaw.sine)
  {
  }
};

/// a followed by b, b given in the frame of a; with the same bits on every machine, which std::sin does not promise.
inline Pose2 chain(const Pose2 & a, const Pose2 & b)
{
  const Vec2 p = Transform2(a).apply({b.x, b.y});
  return {p.x, p.y, a.yaw + b.yaw};
}

/// Position and heading of a pose seen from above.
inline Pose2 planar(const Pose3 & pose)
{
  return {pose.position.x(), pose.position.y(), pose.yaw()};
}

/// A pose relative to its own shadow on the ground: what remains of it without position and heading.
inline Pose3 withoutPlanar(const Pose3 & pose)
{
  const Pose2 p = planar(pose);
  const Pose3 shadow(p.x, p.y, 0.0, 0.0, 0.0, p.yaw);
  return shadow.inverse() * pose;
}
}  // namespace f1tenth_sim2d
