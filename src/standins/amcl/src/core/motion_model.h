#pragma once

#include <workspace_support/maths/random.h>

#include "amcl/geometry.h"
#include "amcl/localizer_options.h"

namespace amcl
{
/// Where a car may have gone when odometry measured a motion. Models: S. Thrun, W. Burgard, D. Fox: Probabilistic
/// Robotics, 2005, chapter 5.4, and the original's for cars that can drive sideways.
class MotionModel
{
public:
  /// @param motion  in the frame of the car before it
  MotionModel(const Pose2 & motion, const OdometryOptions & options);

  /// A pose after the motion from one before it.
  Pose2 sample(const Pose2 & pose, maths::Random & random) const;

private:
  void errLikeDiff(const OdometryOptions & options);
  void errLikeOmni(const OdometryOptions & options);

  Pose2 motion_;
  bool is_omni_;
  double way_;           // m
  double bearing_{0.0};  // rad, of the way
  // Standard deviations: of the way (m) and the final heading (rad), and of the bearing (rad) or, for omni, the way
  // across (m).
  double way_deviation_{0.0};
  double heading_deviation_{0.0};
  double side_deviation_{0.0};
};
}  // namespace amcl
