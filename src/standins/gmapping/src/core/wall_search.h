#pragma once

#include <cstdint>
#include <vector>

#include "cell_map.h"
#include "gmapping/geometry.h"

namespace gmapping
{
/// Where a place is looked for: about a pose, to either side.
struct SearchWindow
{
  Pose2 middle;
  double reach{0.0};  ///< m
  double turn{0.0};   ///< rad
};

/// Finds how points have to lie so that they fall onto walls: by looking everywhere, in two steps, first among coarse
/// cells that are as good as the best cell in them. (E. Olson: Real-Time Correlative Scan Matching, ICRA 2009.)
class WallSearch
{
public:
  /// @param walls  points of them, m
  explicit WallSearch(const std::vector<Vec2> & walls);

  /// The pose of the points' frame with which most of them fall onto walls; among equally good ones one near the middle.
  Pose2 best(const std::vector<Vec2> & points, const SearchWindow & window) const;
  /// Share of the points within a cell of a wall when their frame is there.
  double share(const std::vector<Vec2> & points, const Pose2 & pose) const;

private:
  struct Layer
  {
    GridGeometry geometry;
    std::vector<std::uint8_t> values;

    int valueAt(const Vec2 & point) const;
  };
  struct Candidate
  {
    Pose2 pose;
    double score{0.0};
  };

  static Layer layerOf(const std::vector<Vec2> & walls, double cell);
  static double score(const Layer & layer, const std::vector<Vec2> & turned, const Vec2 & offset);

  Layer fine_;
  Layer coarse_;
};
}  // namespace gmapping
