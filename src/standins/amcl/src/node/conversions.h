#pragma once

#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <workspace_support/conversions.h>

#include <string>
#include <vector>

#include "amcl/localizer.h"

/// Between messages and the core's types.
namespace amcl
{
/// A name of a frame as tf2 knows it: those of tf1 may begin with a slash.
std::string withoutSlash(const std::string & frame);

/// x, y and yaw of the covariance; what is not finite in it counts as 0.
Estimate fromPoseWithCovariance(const geometry_msgs::PoseWithCovariance & pose);
geometry_msgs::PoseWithCovariance toPoseWithCovariance(const Estimate & estimate);
geometry_msgs::PoseArray toPoseArray(const std::vector<Pose2> & poses, const std_msgs::Header & header);
}  // namespace amcl
