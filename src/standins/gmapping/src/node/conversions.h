#pragma once

#include <geometry_msgs/Transform.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>

#include "gmapping/geometry.h"
#include "gmapping/occupancy_grid.h"
#include "gmapping/scan.h"

/// Between messages and the core's types. Quaternions count as rotations about z, of a lidar that may hang upside down.
namespace gmapping
{
/// The x axis of the transform, seen from above.
Pose2 fromTransform(const geometry_msgs::Transform & transform);
geometry_msgs::Transform toTransform(const Pose2 & pose);
/// Whether the z axis of the transform points down.
bool isUpsideDown(const geometry_msgs::Transform & transform);
/// @param upside_down  whether the lidar is: its angles then count clockwise
Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down);
nav_msgs::OccupancyGrid toOccupancyGrid(const OccupancyGrid & grid, const std_msgs::Header & header);
}  // namespace gmapping
