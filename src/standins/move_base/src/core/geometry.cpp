#include "move_base/geometry.h"

namespace move_base
{
namespace
{
// Below it, an arc over any length used here is a straight line to the last bit that matters.
constexpr double kStraightCurvature = 1e-9;
}  // namespace

double normalizeAngle(double angle)
{
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped <= -M_PI ? wrapped + 2.0 * M_PI : wrapped;
}

Vec2 transform(const Pose2 & pose, const Vec2 & point)
{
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return {pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y};
}

Pose2 compose(const Pose2 & pose, const Pose2 & relative)
{
  const Vec2 position = transform(pose, relative.position());
  return {position.x, position.y, normalizeAngle(pose.yaw + relative.yaw)};
}

Pose2 inverse(const Pose2 & pose)
{
  const Vec2 position = transform({0.0, 0.0, -pose.yaw}, {-pose.x, -pose.y});
  return {position.x, position.y, -pose.yaw};
}

Pose2 advance(const Pose2 & pose, double length, double curvature)
{
  if (std::abs(curvature) < kStraightCurvature) {
    return compose(pose, {length, 0.0, 0.0});
  }
  const double turn = length * curvature;
  return compose(pose, {std::sin(turn) / curvature, (1.0 - std::cos(turn)) / curvature, turn});
}
}  // namespace move_base
