#pragma once

#include <workspace_support/scan.h>

#include <cstddef>
#include <set>
#include <vector>

#include "move_base/map/box.h"
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
  double obstacle_range{8.0};   ///< m, hits farther away mark nothing
  double raytrace_range{9.0};   ///< m, free space farther away clears nothing
  double wall_tolerance{0.12};  ///< m, a hit this close to an obstacle of the map is that obstacle; 1.5 cells at least

  /// @throws OptionError
  void validate() const;
};

/// An outline that counts as occupied, however little of it the lidar sees.
struct HeldOutline
{
  Box outline;
  Vec2 seen;  ///< m, a point in it: when the lidar sees through it, all is gone
};

/// Cells in which the lidar has seen what is not on the map, until it sees through them.
class LiveLayer
{
public:
  LiveLayer(const GridGeometry & geometry, const LiveLayerOptions & options);

  /// What the beams of the scan hit that is not on the map, in their order.
  /// @param map_distances  distance of each cell to the map's nearest obstacle, m
  std::vector<Vec2> hits(const LaserScan & scan, const std::vector<float> & map_distances) const;

  /// Marks an outline, unless one that was seen near by is held already. @return whether any cell changed
  bool hold(const HeldOutline & held);

  /// Clears what the beams of the scan pass through, then marks what is hit, on the map.
  /// @return whether any cell changed
  bool observe(const LaserScan & scan, const std::vector<Vec2> & hits);

  /// Forgets everything farther than radius from centre, m. @return whether any cell changed
  bool forgetBeyond(const Vec2 & centre, double radius);
  /// Forgets the cells whose middle is in an outline. @return whether any cell changed
  bool forgetIn(const Box & outline);

  const std::set<std::size_t> & cells() const { return cells_; }

private:
  bool clear(const LaserScan & scan);
  bool isHeld(const Vec2 & point) const;
  template <class Predicate>
  void forgetHeldIf(Predicate predicate);
  bool seesThrough(const LaserScan & scan, const Vec2 & point) const;
  template <class Predicate>
  bool forgetIf(Predicate predicate);

  GridGeometry geometry_;
  LiveLayerOptions options_;
  double wall_tolerance_;  // m
  std::set<std::size_t> cells_;
  std::vector<HeldOutline> held_;
};
}  // namespace move_base
