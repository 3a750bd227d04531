#pragma once

#include <Eigen/Core>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Mass, centre of mass and inertia of a rigid body, in some frame.
struct Inertia
{
  double mass{0.0};                                  ///< kg
  Eigen::Vector3d centre{Eigen::Vector3d::Zero()};   ///< m
  Eigen::Matrix3d moments{Eigen::Matrix3d::Zero()};  ///< kg m^2, about the centre, along the axes of the frame

  /// Whether a body can have it: positive mass and moments, none of which is greater than the sum of the others.
  bool isPossible() const;
};

Eigen::Matrix3d symmetric(double xx, double yy, double zz, double xy, double xz, double yz);

/// The same in the frame in which pose is given.
Inertia placed(const Inertia & inertia, const Pose3 & pose);

/// Of both together.
Inertia operator+(const Inertia & a, const Inertia & b);
}  // namespace f1tenth_sim2d
