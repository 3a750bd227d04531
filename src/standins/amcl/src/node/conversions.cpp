#include "conversions.h"

#include <cmath>

namespace amcl
{
namespace
{
// Rows and columns of x, y and yaw in a covariance of six.
constexpr int kPlane[] = {0, 1, 5};
}  // namespace

std::string withoutSlash(const std::string & frame)
{
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

Estimate fromPoseWithCovariance(const geometry_msgs::PoseWithCovariance & pose)
{
  Estimate estimate;
  estimate.pose = fromPose(pose.pose);
  for (int i = 0; i < 9; ++i) {
    const double value = pose.covariance[6 * kPlane[i / 3] + kPlane[i % 3]];
    estimate.covariance[i] = std::isfinite(value) ? value : 0.0;
  }
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
