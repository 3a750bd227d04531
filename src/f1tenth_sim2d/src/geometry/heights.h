#pragma once

#include <algorithm>

#include "geometry/planar.h"

namespace f1tenth_sim2d
{
/// The heights that a solid fills, m.
struct Heights
{
  double lowest;
  double highest;

  /// The lowest height belongs to the solid, the highest one does not.
  bool contain(double z) const { return z >= lowest - kTolerance && z < highest - kTolerance; }
  /// Whether there is more than a touch between these heights and the span.
  bool overlap(double z_min, double z_max) const
  {
    return std::min(highest, z_max) - std::max(lowest, z_min) > kTolerance;
  }
};
}  // namespace f1tenth_sim2d
