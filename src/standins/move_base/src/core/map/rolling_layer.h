#pragma once

#include <cstdint>
#include <vector>

#include "move_base/map/geometry.h"
#include "move_base/map/live_layer.h"

namespace move_base
{
/// What the lidar sees around the car, and nothing else: a window of fixed size that moves along with it, in a frame of
/// its own. No decision depends on it; it is shown as the local costmap.
class RollingLayer
{
public:
  /// @param width, height  m, above 0
  /// @param resolution     m, of a cell, above 0
  RollingLayer(double width, double height, double resolution, const LiveLayerOptions & options);

  /// Puts the car into the middle, to within a cell. What leaves the window is forgotten.
  void moveTo(const Vec2 & car);
  /// Clears what the beams pass through and marks what they hit; neither beyond the ranges of the options.
  /// @param scan  its sensor in the frame of the window
  void observe(const LaserScan & scan);

  const GridGeometry & geometry() const { return geometry_; }
  /// 100 obstacle, 0 free, row by row.
  const std::vector<std::int8_t> & cells() const { return cells_; }

private:
  void clearAlong(const LaserScan & scan, const Vec2 & direction, double range);

  GridGeometry geometry_;
  LiveLayerOptions options_;
  std::vector<std::int8_t> cells_;
};
}  // namespace move_base
