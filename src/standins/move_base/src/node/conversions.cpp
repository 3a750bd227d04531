#include "conversions.h"

#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>

namespace move_base
{
geometry_msgs::PoseStamped toPoseStamped(const Pose2 & pose, const std_msgs::Header & header)
{
  geometry_msgs::PoseStamped message;
  message.header = header;
  message.pose = toPose(pose);
  return message;
}

bool isPlanar(const geometry_msgs::Quaternion & q)
{
  const double squared = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!std::isfinite(squared) || squared < 1e-6) {
    return false;
  }
  const double upright = 1.0 - 2.0 * (q.x * q.x + q.y * q.y) / squared;  // z component of the turned z axis
  return std::abs(upright - 1.0) <= 1e-3;
}

OccupancyGrid fromUnturnedGrid(const nav_msgs::OccupancyGrid & message)
{
  OccupancyGrid grid = fromOccupancyGrid(message);
  if (std::abs(grid.geometry.origin.yaw) > 1e-6) {
    throw Error("map: origin has the yaw " + std::to_string(grid.geometry.origin.yaw) + ", must be 0");
  }
  return grid;
}

LaserScan fromLaserScan(const sensor_msgs::LaserScan & message, const Pose2 & sensor)
{
  return {workspace_support::fromLaserScan(message, false), sensor, message.header.stamp.toSec()};
}

nav_msgs::Path toPath(const std::vector<Pose2> & poses, const std_msgs::Header & header)
{
  nav_msgs::Path path;
  path.header = header;
  for (const Pose2 & pose : poses) {
    path.poses.push_back(toPoseStamped(pose, header));
  }
  return path;
}

std::vector<Pose2> posesOf(const Path & path)
{
  std::vector<Pose2> poses(path.size());
  std::transform(path.begin(), path.end(), poses.begin(), [](const PathPoint & point) { return point.pose; });
  return poses;
}

geometry_msgs::PolygonStamped toPolygon(
  const std::vector<Vec2> & footprint, const Pose2 & pose, const std_msgs::Header & header)
{
  geometry_msgs::PolygonStamped polygon;
  polygon.header = header;
  for (const Vec2 & corner : footprint) {
    const Vec2 at = transform(pose, corner);
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(at.x);
    point.y = static_cast<float>(at.y);
    polygon.polygon.points.push_back(point);
  }
  return polygon;
}
}  // namespace move_base
