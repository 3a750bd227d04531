#include "move_base/map/geometry.h"

#include <algorithm>

namespace move_base
{
namespace
{
// Below it, an arc over any length used here is a straight line to the last bit that matters.
constexpr double kStraightCurvature = 1e-9;
}  // namespace

Pose2 advance(const Pose2 & pose, double length, double curvature)
{
  if (std::abs(curvature) < kStraightCurvature) {
    return compose(pose, {length, 0.0, 0.0});
  }
  const double turn = length * curvature;
  return compose(pose, {maths::sin(turn) / curvature, (1.0 - maths::cos(turn)) / curvature, turn});
}

Vec2 leftNormal(const Pose2 & pose)
{
  return {-maths::sin(pose.yaw), maths::cos(pose.yaw)};
}

Pose2 between(const Pose2 & a, const Pose2 & b, double part)
{
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.yaw + part * normalizeAngle(b.yaw - a.yaw)};
}

double nearestPart(const Vec2 & a, const Vec2 & b, const Vec2 & point)
{
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  return squared > 0.0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
}

double distanceToLine(const Vec2 & a, const Vec2 & b, const Vec2 & point)
{
  return distance(a + nearestPart(a, b, point) * (b - a), point);
}
}  // namespace move_base
