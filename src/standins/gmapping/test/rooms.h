#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "gmapping/geometry.h"

namespace gmapping
{
/// What a lidar sees at pose in a rectangular room from (-3.02, -2.52) to (5.02, 2.52), m, without noise.
inline Scan scanInRoom(const Pose2 & pose, int beams = 1441)
{
  Scan scan;
  scan.angle_min = -M_PI;
  scan.angle_increment = 2.0 * M_PI / (beams - 1);
  scan.range_min = 0.05;
  scan.range_max = 10.0;
  for (int i = 0; i < beams; ++i) {
    const double angle = pose.yaw + scan.angle_min + i * scan.angle_increment;
    const double x = std::cos(angle) > 0.0 ? 5.02 - pose.x : -3.02 - pose.x;
    const double y = std::sin(angle) > 0.0 ? 2.52 - pose.y : -2.52 - pose.y;
    scan.ranges.push_back(static_cast<float>(std::min(x / std::cos(angle), y / std::sin(angle))));
  }
  return scan;
}
}  // namespace gmapping
