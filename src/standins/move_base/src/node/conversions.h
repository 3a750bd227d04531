#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/LaserScan.h>
#include <workspace_support/conversions.h>

#include <vector>

#include "move_base/map/costmap.h"
#include "move_base/path/path.h"

/// Between messages and the core's types. Quaternions count as rotations about z.
namespace move_base
{
geometry_msgs::PoseStamped toPoseStamped(const Pose2 & pose, const std_msgs::Header & header);

/// Whether it is a rotation about z alone, as a goal must have.
bool isPlanar(const geometry_msgs::Quaternion & rotation);

/// @throws Error for a map that is rotated
OccupancyGrid fromUnturnedGrid(const nav_msgs::OccupancyGrid & message);

/// @param sensor  in the map, when the scan was taken
LaserScan fromLaserScan(const sensor_msgs::LaserScan & message, const Pose2 & sensor);

nav_msgs::Path toPath(const std::vector<Pose2> & poses, const std_msgs::Header & header);
std::vector<Pose2> posesOf(const Path & path);

/// The footprint of a car at pose.
geometry_msgs::PolygonStamped toPolygon(
  const std::vector<Vec2> & footprint, const Pose2 & pose, const std_msgs::Header & header);
}  // namespace move_base
