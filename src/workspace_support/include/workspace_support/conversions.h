#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "workspace_support/grid.h"
#include "workspace_support/planar.h"
#include "workspace_support/scan.h"

/// Between messages and plain types. Quaternions count as rotations about z; a lidar may hang upside down.
namespace workspace_support
{
/// A frame name as tf2 knows it: names of tf1 may begin with a slash.
std::string withoutSlash(const std::string & frame);
std_msgs::Header headerOf(const std::string & frame, const ros::Time & stamp);
/// The x axis of the pose, seen from above.
Pose2 fromPose(const geometry_msgs::Pose & pose);
geometry_msgs::Pose toPose(const Pose2 & pose);
/// @param position, rotation  in space: a vector and a unit quaternion of Eigen
template <typename Position, typename Rotation>
geometry_msgs::Pose toPose(const Position & position, const Rotation & rotation)
{
  geometry_msgs::Pose message;
  message.position.x = position.x();
  message.position.y = position.y();
  message.position.z = position.z();
  message.orientation.x = rotation.x();
  message.orientation.y = rotation.y();
  message.orientation.z = rotation.z();
  message.orientation.w = rotation.w();
  return message;
}
Pose2 fromTransform(const geometry_msgs::Transform & transform);
geometry_msgs::Transform toTransform(const Pose2 & pose);
geometry_msgs::Transform toTransform(const geometry_msgs::Pose & pose);
/// Pose of a frame in another one; time 0: the latest. Nothing if it is not known.
std::optional<geometry_msgs::TransformStamped> lookUp(
  const tf2::BufferCore & transforms, const std::string & target, const std::string & frame, const ros::Time & stamp);
/// Whether the z axis of the transform points down.
bool isUpsideDown(const geometry_msgs::Transform & transform);
/// The map with its origin as given: x, y and yaw.
OccupancyGrid fromOccupancyGrid(const nav_msgs::OccupancyGrid & message);
nav_msgs::OccupancyGrid toOccupancyGrid(const OccupancyGrid & grid, const std_msgs::Header & header);
/// @param upside_down  whether the lidar is: its angles then count clockwise
Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down);
}  // namespace workspace_support
