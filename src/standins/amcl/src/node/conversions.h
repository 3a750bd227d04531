#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <geometry_msgs/Transform.h>
#include <nav_msgs/OccupancyGrid.h>
#include <sensor_msgs/LaserScan.h>

#include <vector>

#include "amcl/localizer.h"

/// Between messages and the core's types. Quaternions count as rotations about z, of a lidar that may hang upside down.
namespace amcl
{
/// The x axis of the pose, seen from above.
Pose2 fromPose(const geometry_msgs::Pose & pose);
geometry_msgs::Pose toPose(const Pose2 & pose);
Pose2 fromTransform(const geometry_msgs::Transform & transform);
geometry_msgs::Transform toTransform(const Pose2 & pose);
/// Whether the z axis of the transform points down.
bool isUpsideDown(const geometry_msgs::Transform & transform);
/// x, y and yaw of the covariance; what is not finite in it counts as 0.
Estimate fromPoseWithCovariance(const geometry_msgs::PoseWithCovariance & pose);
geometry_msgs::PoseWithCovariance toPoseWithCovariance(const Estimate & estimate);
/// @param upside_down  whether the lidar is: its angles then count clockwise
Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down);
OccupancyGrid fromOccupancyGrid(const nav_msgs::OccupancyGrid & message);
geometry_msgs::PoseArray toPoseArray(const std::vector<Pose2> & poses, const std_msgs::Header & header);
}  // namespace amcl
