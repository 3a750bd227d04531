#pragma once

#include <workspace_support/maths/exponential.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "move_base/map/footprint.h"
#include "move_base/map/geometry.h"
#include "move_base/map/live_layer.h"

namespace move_base
{
struct CostmapOptions
{
  /// Whether unknown cells of the map may be driven on; those of a patch narrower than a car always may.
  bool allow_unknown{false};
  int lethal_cost_threshold{100};    ///< a cell of the map with at least this occupancy is an obstacle
  double inflation_radius{0.55};     ///< m, obstacles farther away from the car's axis cost nothing
  double cost_scaling_factor{10.0};  ///< 1/m, how fast the cost falls with distance
  LiveLayerOptions live;

  /// @throws OptionError
  void validate() const;
};

/// Distances to obstacles of the map and of the lidar, and what it costs to drive near them.
class Costmap
{
public:
  /// @throws Error for an empty map, OptionError
  Costmap(const OccupancyGrid & map, const CostmapOptions & options, const Footprint & footprint);

  const GridGeometry & geometry() const { return geometry_; }
  const CostmapOptions & options() const { return options_; }
  const Footprint & footprint() const { return footprint_; }

  /// What the beams of a scan hit that is not on the map, in their order, m.
  std::vector<Vec2> hits(const LaserScan & scan) const { return live_.hits(scan, map_distances_); }
  /// Whether a beam of a scan passes through a place.
  bool seesThrough(const LaserScan & scan, const Vec2 & place) const { return live_.seesThrough(scan, place); }
  /// Takes a scan into the live layer: clears what its beams pass through, and marks places on the map.
  void observe(const LaserScan & scan, const std::vector<Vec2> & places);
  void observe(const LaserScan & scan) { observe(scan, hits(scan)); }
  /// Whether something is marked at a place on the map.
  bool isMarked(const Vec2 & place) const { return live_.cells().count(geometry_.index(geometry_.cellAt(place))) > 0; }
  /// Forgets what the lidar saw where this is true; distances change with the next scan.
  void forgetIf(const std::function<bool(const Vec2 &)> & is_over) { changed_ = live_.forgetIf(is_over) || changed_; }
  /// Forgets what the lidar saw farther than radius from centre, m.
  void forgetBeyond(const Vec2 & centre, double radius);
  /// Forgets everything that the lidar saw.
  void forgetAll() { forgetBeyond({}, -1.0); }

  /// Distance from a point to the nearest standing obstacle, m; 0 or less inside of one and outside of the map.
  double obstacleDistance(const Vec2 & point) const { return distanceIn(distances_, point); }
  /// The same to the nearest obstacle of the map.
  double wallDistance(const Vec2 & point) const { return distanceIn(map_distances_, point); }

  /// Whether the lidar has seen something that is not on the map within reach of a point, m.
  bool seesUnknown(const Vec2 & point, double reach) const;

  /// Whether the map knows nothing of a cell.
  bool isUnknown(std::size_t index) const { return unknown_[index] != 0; }

  /// Least distance from the car's outline to an obstacle, m, less what the discs stick out; negative on contact.
  double clearance(const Pose2 & base) const;

  /// Whether the car here and up to margin beside it is surely so far from every obstacle that none adds to what
  /// driving costs, and margin farther than that. One look-up in the map instead of one for each disc; false tells
  /// nothing.
  bool isFarFromAll(const Pose2 & base, double margin) const;

  static constexpr double kTouchingPrice = 4.0;  ///< of a metre with a side touching, in metres of free road
  /// What a metre costs beyond its length when the obstacle next to the car's axis is at this clearance, m.
  double proximityCost(double clearance) const
  {
    if (clearance >= free_clearance_) {
      return 0.0;
    }
    return kTouchingPrice * maths::exp(-options_.cost_scaling_factor * std::max(clearance, 0.0));
  }

  /// Where the lidar has seen obstacles that are not on the map.
  const std::vector<Cell> & liveCells() const { return stamped_; }
  /// What a cell costs as messages show it: 100 obstacle, 99 where the car surely touches one, falling to 0; -1 unknown.
  std::int8_t shownCost(std::size_t index) const;

private:
  double distanceIn(const std::vector<float> & distances, const Vec2 & point) const
  {
    const double gx = (point.x - geometry_.origin.x) / geometry_.resolution - 0.5;
    const double gy = (point.y - geometry_.origin.y) / geometry_.resolution - 0.5;
    if (!(gx >= 0.0 && gy >= 0.0 && gx < geometry_.width - 1 && gy < geometry_.height - 1)) {
      return -half_cell_;
    }
    const int ix = static_cast<int>(gx);
    const int iy = static_cast<int>(gy);
    const double fx = gx - ix;
    const double fy = gy - iy;
    const float * low = distances.data() + geometry_.index({ix, iy});
    const float * high = low + geometry_.width;
    return (1.0 - fy) * ((1.0 - fx) * low[0] + fx * low[1]) + fy * ((1.0 - fx) * high[0] + fx * high[1]) - half_cell_;
  }

  bool isInside(const Vec2 & middle, double room) const;
  bool isNearLive(const Vec2 & middle, double reach) const;
  void makeStamp();
  void rebuild();
  void stamp(const Cell & cell);
  /// Calls visit(index of the first cell in the map, the same in the stamp, number) for each row of a stamp at a cell.
  template <class Visit>
  void forStampRows(const Cell & cell, const Visit & visit) const;

  GridGeometry geometry_;
  CostmapOptions options_;
  Footprint footprint_;
  double half_cell_;
  double free_clearance_;
  std::vector<std::uint8_t> unknown_;
  std::vector<float> map_distances_;  // m, between cell centres
  std::vector<float> distances_;      // the same with the live layer's cells
  LiveLayer live_;
  bool changed_{false};                // whether distances_ lag behind the live layer
  int stamp_reach_{0};                 // cells from the middle of the stamp to its edges
  std::vector<float> stamp_;           // m, from the middle, row by row; infinite beyond what matters
  std::vector<Cell> stamped_;          // where the stamp is in distances_
  Vec2 live_low_{HUGE_VAL, HUGE_VAL};  // m, corners of a rectangle around all that is stamped
  Vec2 live_high_{-HUGE_VAL, -HUGE_VAL};
};
}  // namespace move_base
