#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <workspace_support/conversions.h>

#include <vector>

#include "amcl/localizer.h"

/// Between messages and the core's types.
namespace amcl
{
/// x, y and yaw of the covariance, whose halves are averaged; what is not finite in it counts as 0.
/// @throws Error for a pose that is not finite, and for an impossible covariance
Estimate fromPoseWithCovariance(const geometry_msgs::PoseWithCovariance & pose);
geometry_msgs::PoseWithCovariance toPoseWithCovariance(const Estimate & estimate);
geometry_msgs::PoseArray toPoseArray(const std::vector<Pose2> & poses, const std_msgs::Header & header);
}  // namespace amcl
