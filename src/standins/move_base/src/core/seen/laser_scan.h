#pragma once

#include <workspace_support/scan.h>

#include "geometry/geometry.h"

namespace move_base
{
/// A scan and where it was taken. +inf: nothing hit (REP-117).
struct LaserScan : Scan
{
  Pose2 sensor;      ///< in the map, when the scan was taken
  double time{0.0};  ///< s, when it was taken
};
}  // namespace move_base
