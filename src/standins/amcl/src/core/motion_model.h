#pragma once

#include <Eigen/Core>

#include "amcl/geometry.h"
#include "amcl/localizer_options.h"

namespace amcl
{
/// How certain a motion measured by odometry is: covariance of x (m), y (m) and yaw (rad) in the frame of the car
/// before the motion, to first order. Models: S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics, 2005, chapter 5.4,
/// and the original's for cars that can drive sideways.
Eigen::Matrix3d motionCovariance(const Pose2 & motion, const OdometryOptions & options);
}  // namespace amcl
