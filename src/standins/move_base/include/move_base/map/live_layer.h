#pragma once

#include <workspace_support/scan.h>

#include <cstddef>
#include <functional>
#include <set>
#include <vector>

#include "move_base/map/geometry.h"

namespace move_base
{
/// A scan and where it was taken. +inf: nothing hit (REP-117).
struct LaserScan : Scan
{
  Pose2 sensor;      ///< in the map, when the scan was taken
  double time{0.0};  ///< s, when it was taken
};

struct LiveLayerOptions
{
  double obstacle_range{8.0};  ///< m, hits farther away mark nothing
  double raytrace_range{9.0};  ///< m, free space farther away clears nothing

  /// @throws OptionError
  void validate() const;
};

/// Cells in which the lidar has seen what is not on the map, until it sees through them.
class LiveLayer
{
public:
  LiveLayer(const GridGeometry & geometry, const LiveLayerOptions & options);

  /// What the beams of the scan hit that is not on the map, in their order.
  /// @param map_distances  distance of each cell to the map's nearest obstacle, m
  std::vector<Vec2> hits(const LaserScan & scan, const std::vector<float> & map_distances) const;

  /// Clears what the beams of the scan pass through, then marks places on the map.
  /// @return whether any cell changed
  bool observe(const LaserScan & scan, const std::vector<Vec2> & places);
  /// Forgets the cells for whose middle it is true. @return whether any cell changed
  bool forgetIf(const std::function<bool(const Vec2 &)> & is_over);

  /// Whether a beam of the scan passes through a place.
  bool seesThrough(const LaserScan & scan, const Vec2 & place) const;

  const std::set<std::size_t> & cells() const { return cells_; }

private:
  GridGeometry geometry_;
  LiveLayerOptions options_;
  double wall_tolerance_;  // m, a hit this close to an obstacle of the map is that obstacle
  std::set<std::size_t> cells_;
};
}  // namespace move_base
