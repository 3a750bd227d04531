#include "workspace_support/conversions.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

namespace workspace_support
{
namespace
{
double yawOf(const geometry_msgs::Quaternion & q)
{
  return maths::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

geometry_msgs::Quaternion toQuaternion(double yaw)
{
  geometry_msgs::Quaternion q;
  q.z = maths::sin(0.5 * yaw);
  q.w = maths::cos(0.5 * yaw);
  return q;
}
}  // namespace

std::string withoutSlash(const std::string & frame)
{
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

std_msgs::Header headerOf(const std::string & frame, const ros::Time & stamp)
{
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = stamp;
  return header;
}

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
  return toTransform(toPose(pose));
}

geometry_msgs::Transform toTransform(const geometry_msgs::Pose & pose)
{
  geometry_msgs::Transform transform;
  transform.translation.x = pose.position.x;
  transform.translation.y = pose.position.y;
  transform.translation.z = pose.position.z;
  transform.rotation = pose.orientation;
  return transform;
}

std::optional<geometry_msgs::TransformStamped> lookUp(
  const tf2::BufferCore & transforms, const std::string & target, const std::string & frame, const ros::Time & stamp)
{
  if (!transforms.canTransform(target, frame, stamp)) {
    return std::nullopt;
  }
  return transforms.lookupTransform(target, frame, stamp);
}

bool isUpsideDown(const geometry_msgs::Transform & transform)
{
  const auto & q = transform.rotation;
  return 1.0 - 2.0 * (q.x * q.x + q.y * q.y) < 0.0;
}

OccupancyGrid fromOccupancyGrid(const nav_msgs::OccupancyGrid & message)
{
  OccupancyGrid grid;
  grid.geometry.width = static_cast<int>(message.info.width);
  grid.geometry.height = static_cast<int>(message.info.height);
  grid.geometry.resolution = message.info.resolution;
  grid.geometry.origin = fromPose(message.info.origin);
  grid.cells.assign(message.data.begin(), message.data.end());
  return grid;
}

nav_msgs::OccupancyGrid toOccupancyGrid(const OccupancyGrid & grid, const std_msgs::Header & header)
{
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.resolution = static_cast<float>(grid.geometry.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.geometry.width);
  message.info.height = static_cast<std::uint32_t>(grid.geometry.height);
  message.info.origin = toPose(grid.geometry.origin);
  message.data.assign(grid.cells.begin(), grid.cells.end());
  return message;
}

Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down)
{
  const double sense = upside_down ? -1.0 : 1.0;
  return {
    sense * message.angle_min, sense * message.angle_increment, message.range_min, message.range_max, message.ranges};
}
}  // namespace workspace_support
