#pragma once

#include <ignition/math/Pose3.hh>

#include "f1tenth_sim2d/pose3.h"

/// libsdformat speaks Ignition's mathematics, everything here Eigen's.
namespace f1tenth_sim2d
{
inline Eigen::Vector3d fromIgnition(const ignition::math::Vector3d & v)
{
  return {v.X(), v.Y(), v.Z()};
}

inline Pose3 fromIgnition(const ignition::math::Pose3d & pose)
{
  return {fromIgnition(pose.Pos()), {pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()}};
}
}  // namespace f1tenth_sim2d
