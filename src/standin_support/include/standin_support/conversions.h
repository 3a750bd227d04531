#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <sensor_msgs/LaserScan.h>

#include "standin_support/geometry.h"
#include "standin_support/scan.h"

/// Between messages and plain types. Quaternions count as rotations about z, of a lidar that may hang upside down.
namespace standin_support
{
/// The x axis of the pose, seen from above.
Pose2 fromPose(const geometry_msgs::Pose & pose);
geometry_msgs::Pose toPose(const Pose2 & pose);
Pose2 fromTransform(const geometry_msgs::Transform & transform);
geometry_msgs::Transform toTransform(const Pose2 & pose);
/// Whether the z axis of the transform points down.
bool isUpsideDown(const geometry_msgs::Transform & transform);
/// @param upside_down  whether the lidar is: its angles then count clockwise
Scan fromLaserScan(const sensor_msgs::LaserScan & message, bool upside_down);
}  // namespace standin_support
