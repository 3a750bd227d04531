#pragma once

#include <algorithm>

#include "f1tenth_sim2d/world_model.h"
#include "geometry/planar.h"

namespace f1tenth_sim2d
{
/// The heights that a solid fills, m.
struct Heights
{
  double lowest;
  double highest;

  bool isEmpty() const { return lowest > highest; }
  /// The lowest height belongs to the solid, the highest one does not.
  bool contain(double z) const { return z >= lowest - kTolerance && z < highest - kTolerance; }
  /// Whether there is more than a touch between these heights and the span.
  bool overlap(double z_min, double z_max) const
  {
    return std::min(highest, z_max) - std::max(lowest, z_min) > kTolerance;
  }
};

/// @param pose  of the shape in the frame in which the heights are given. A Plane fills none.
Heights heightsOf(const Shape & shape, const Pose3 & pose);
}  // namespace f1tenth_sim2d
