#pragma once

#include <cmath>

/// Geometry of the plane: m, rad, REP-103 axes.
namespace standin_support
{
struct Pose2
{
  double x{0.0};
  double y{0.0};
  double yaw{0.0};
};

/// The same angle in [-pi, pi].
inline double normalizeAngle(double angle)
{
  return std::remainder(angle, 2.0 * M_PI);
}

/// A pose given in the frame of pose, in the frame in which pose is given.
inline Pose2 compose(const Pose2 & pose, const Pose2 & relative)
{
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return {
    pose.x + c * relative.x - s * relative.y, pose.y + s * relative.x + c * relative.y,
    normalizeAngle(pose.yaw + relative.yaw)};
}

inline Pose2 inverse(const Pose2 & pose)
{
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return {-c * pose.x - s * pose.y, s * pose.x - c * pose.y, -pose.yaw};
}
}  // namespace standin_support
