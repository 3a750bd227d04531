#pragma once

#include <Eigen/Core>
#include <vector>

#include "beams.h"
#include "gmapping/geometry.h"
#include "gmapping/slam_options.h"
#include "local_map.h"
#include "motion.h"
#include "scan_matcher.h"

namespace gmapping
{
/// Follows the lidar by matching its scans to a map of the way just behind, one every 0.1 m: many looks make up for
/// the noise of each. Its poses are smooth, but they drift.
class ScanTracker
{
public:
  ScanTracker(const MatcherOptions & matcher, const MotionNoise & odometry);

  /// @param max_urange  m, farther than this nothing is put into the map
  void start(const std::vector<Beam> & beams, const Pose2 & pose, double max_urange);
  /// @param motion  since the last call, as odometry says, in the frame of the lidar then
  void drive(const Pose2 & motion);
  /// Whether the lidar has moved far enough for another look.
  bool isDue() const;
  /// Matches a scan to the map, and adds it to the map.
  /// @throws Error for a map that is too large; the lidar is followed all the same
  void look(const std::vector<Beam> & beams);

  /// At the last look.
  const Pose2 & pose() const { return pose_; }
  /// What its scan told of the pose, odometry left out: nothing if it did not fit.
  const Eigen::Matrix3d & information() const { return information_; }

private:
  ScanMatcher matcher_;
  MotionNoise noise_;
  double minimum_score_;
  LocalMap map_;
  Pose2 pose_;
  Pose2 motion_;       // since the last look, in the frame of the lidar then
  Progress progress_;  // since then
  Eigen::Matrix3d information_{Eigen::Matrix3d::Zero()};
  double max_urange_{0.0};  // m
};
}  // namespace gmapping
