#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "gmapping/geometry.h"

namespace gmapping
{
/// What is known of where one pose is, seen from another one.
struct PoseEdge
{
  std::size_t from{0};
  std::size_t to{0};
  Pose2 relative;               ///< of `to` in the frame of `from`, m and rad
  Eigen::Matrix3d information;  ///< inverse of its covariance: x, y (m) and yaw (rad) in the frame of `from`
  /// A loop may be a mistake: then it counts less, the more it disagrees with all else.
  bool is_loop{false};
  /// Whether it holds the pose in every direction.
  bool is_firm{true};
};

/// Poses along a way and what connects them. The first one stays where it is.
class PoseGraph
{
public:
  void add(const Pose2 & pose) { poses_.push_back(pose); }
  void connect(const PoseEdge & edge) { edges_.push_back(edge); }
  /// Takes all edges out that are not firm.
  void keepFirm();
  /// Moves the poses to where the edges agree best.
  void optimize();

  const std::vector<Pose2> & poses() const { return poses_; }

private:
  std::vector<Pose2> poses_;
  std::vector<PoseEdge> edges_;
};
}  // namespace gmapping
