#pragma once

#include <vector>

#include "beams.h"
#include "gmapping/geometry.h"

namespace gmapping
{
/// A scan that counted.
struct Stop
{
  Pose2 local;              ///< of the lidar, as ScanTracker says: smooth, but it drifts
  std::vector<Beam> beams;  ///< what was hit
  double distance{0.0};     ///< driven until here, m
};

/// All of them, in order.
using Way = std::vector<Stop>;
}  // namespace gmapping
