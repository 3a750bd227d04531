#pragma once

#include <vector>

#include "move_base/geometry.h"

namespace move_base
{
/// One turn of a level lidar. Beam i points at angle_min + i * angle_increment; +inf: nothing hit (REP-117).
struct LaserScan
{
  Pose2 sensor;                 ///< in the map, when the scan was taken
  double angle_min{0.0};        ///< rad, in the sensor's frame
  double angle_increment{0.0};  ///< rad
  double range_min{0.0};        ///< m
  double range_max{0.0};        ///< m
  std::vector<float> ranges;    ///< m
  double time{0.0};             ///< s, when it was taken
};
}  // namespace move_base
