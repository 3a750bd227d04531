#pragma once

#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"
#include "scan_matcher.h"

namespace gmapping
{
/// What has been driven.
struct Progress
{
  double distance{0.0};  ///< m
  double turn{0.0};      ///< rad, to either side

  void add(const Pose2 & motion);
};

/// Where the lidar is after it has moved as odometry says.
/// @param motion    in the frame of the lidar before it
/// @param progress  way and turn of the motion, which may be longer than from its start to its end
PoseBelief expectedPose(const Pose2 & pose, const Pose2 & motion, const Progress & progress, const MotionNoise & noise);
}  // namespace gmapping
