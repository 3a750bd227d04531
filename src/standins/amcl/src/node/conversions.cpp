#include "conversions.h"

#include <cmath>

namespace amcl
{
namespace
{
// Rows and columns of x, y and yaw in a covariance of six.
constexpr int kPlane[] = {0, 1, 5};
}  // namespace

Estimate fromPoseWithCovariance(const geometry_msgs::PoseWithCovariance & pose)
{
  Estimate estimate;
  estimate.pose = fromPose(pose.pose);
  for (int i = 0; i < 9; ++i) {
    const int row = kPlane[i / 3];
    const int column = kPlane[i % 3];
    const double value = 0.5 * (pose.covariance[6 * row + column] + pose.covariance[6 * column + row]);
    estimate.covariance[i] = std::isfinite(value) ? value : 0.0;
  }
  estimate.validate();
  return estimate;
}

geometry_msgs::PoseWithCovariance toPoseWithCovariance(const Estimate & estimate)
{
  geometry_msgs::PoseWithCovariance message;
  message.pose = toPose(estimate.pose);
  for (int i = 0; i < 9; ++i) {
    message.covariance[6 * kPlane[i / 3] + kPlane[i % 3]] = estimate.covariance[i];
  }
  return message;
}

geometry_msgs::PoseArray toPoseArray(const std::vector<Pose2> & poses, const std_msgs::Header & header)
{
  geometry_msgs::PoseArray message;
  message.header = header;
  message.poses.reserve(poses.size());
  for (const Pose2 & pose : poses) {
    message.poses.push_back(toPose(pose));
  }
  return message;
}
}  // namespace amcl
