#pragma once

#include <vector>

namespace workspace_support
{
/// A scan of a lidar in the plane. Angles in the lidar's frame: 0 is its x axis, left is positive.
struct Scan
{
  double angle_min{0.0};        ///< rad, of the first beam
  double angle_increment{0.0};  ///< rad, from one beam to the next; negative for a lidar that hangs upside down
  double range_min{0.0};        ///< m
  double range_max{0.0};        ///< m
  std::vector<float> ranges;    ///< m; values that are not finite, or below range_min, are no hits
};
}  // namespace workspace_support
