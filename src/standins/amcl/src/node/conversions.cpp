#include "conversions.h"

#include <cmath>

namespace amcl
{
namespace
{
// Rows and columns of x, y and yaw in a covariance of six.
constexpr int kPlane[] = {0, 1, 5};

double yawOf(const geometry_msgs::Quaternion & q)
{
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

geometry_msgs::Quaternion toQuaternion(double yaw)
{
  geometry_msgs::Quaternion q;
  q.z = std::sin(0.5 * yaw);
  q.w = std::cos(0.5 * yaw);
  return q;
}
}  // namespace

Pose2 fromPose(const geometry_msgs::Pose & pose)
{
  return {pose.position.x, pose.position.y, yawOf(pose.orientation)};
}

geometry_msgs::Pose toPose(const Pose2 & pose)
{
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation = toQuaternion(pose.yaw);
  return message;
}

Pose2 fromTransform(const geometry_msgs::Transform & transform)
{
  return {transform.translation.x, transform.translation.y, yawOf(transform.rotation)};
}

geometry_msgs::Transform toTransform(const Pose2 & pose)
{
  geometry_msgs::Transform transform;
  transform.translation.x = pose.x;
  transform.translation.y = pose.y;
  transform.rotation = toQuaternion(pose.yaw);
  return transform;
}

bool isUpsideDown(const geometry_msgs::Transform & transform)
{
  const auto & q = transform.rotation;
  return 1.0 - 2.0 * (q.x * q.x + q.y * q.y) < 0.0;
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

Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down)
{
  const double sense = upside_down ? -1.0 : 1.0;
  return {
    sense * message.angle_min, sense * message.angle_increment, message.range_min, message.range_max, message.ranges};
}

OccupancyGrid fromOccupancyGrid(const nav_msgs::OccupancyGrid & message)
{
  OccupancyGrid grid;
  grid.resolution = message.info.resolution;
  grid.origin = fromPose(message.info.origin);
  grid.width = static_cast<int>(message.info.width);
  grid.height = static_cast<int>(message.info.height);
  grid.cells.assign(message.data.begin(), message.data.end());
  return grid;
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
