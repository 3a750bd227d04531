#include "conversions.h"

#include <cmath>

namespace gmapping
{
Pose2 fromTransform(const geometry_msgs::Transform & transform)
{
  const auto & q = transform.rotation;
  const double yaw = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  return {transform.translation.x, transform.translation.y, yaw};
}

geometry_msgs::Transform toTransform(const Pose2 & pose)
{
  geometry_msgs::Transform transform;
  transform.translation.x = pose.x;
  transform.translation.y = pose.y;
  transform.rotation.z = std::sin(0.5 * pose.yaw);
  transform.rotation.w = std::cos(0.5 * pose.yaw);
  return transform;
}

bool isUpsideDown(const geometry_msgs::Transform & transform)
{
  const auto & q = transform.rotation;
  return 1.0 - 2.0 * (q.x * q.x + q.y * q.y) < 0.0;
}

Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down)
{
  const double sense = upside_down ? -1.0 : 1.0;
  return {
    sense * message.angle_min, sense * message.angle_increment, message.range_min, message.range_max, message.ranges};
}

nav_msgs::OccupancyGrid toOccupancyGrid(const OccupancyGrid & grid, const std_msgs::Header & header)
{
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position.x = grid.x;
  message.info.origin.position.y = grid.y;
  message.info.origin.orientation.w = 1.0;
  message.data.assign(grid.cells.begin(), grid.cells.end());
  return message;
}
}  // namespace gmapping
