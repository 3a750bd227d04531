#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <nav_msgs/OccupancyGrid.h>
#include <standin_support/conversions.h>

#include <vector>

#include "amcl/localizer.h"

/// Between messages and the core's types.
namespace amcl
{
using standin_support::fromLaserScan;
using standin_support::fromPose;
using standin_support::fromTransform;
using standin_support::isUpsideDown;
using standin_support::toPose;
using standin_support::toTransform;

/// x, y and yaw of the covariance; what is not finite in it counts as 0.
Estimate fromPoseWithCovariance(const geometry_msgs::PoseWithCovariance & pose);
geometry_msgs::PoseWithCovariance toPoseWithCovariance(const Estimate & estimate);
OccupancyGrid fromOccupancyGrid(const nav_msgs::OccupancyGrid & message);
geometry_msgs::PoseArray toPoseArray(const std::vector<Pose2> & poses, const std_msgs::Header & header);
}  // namespace amcl
