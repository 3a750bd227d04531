#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cstdint>
#include <vector>

#include "amcl/geometry.h"

namespace amcl
{
using Points = std::vector<Vec2>;

/// For each cell of a map how well a beam fits that ends there: 1 at a wall, less about it.
class FitField
{
public:
  /// @param slack      m from a wall that count as nothing
  /// @param deviation  m, standard deviation of what is beyond them
  FitField(const mrpt::maps::COccupancyGridMap2D & map, double slack, double deviation);

  /// Mean over the points, which are in the frame of the pose; 0 as soon as it is certain to be less than that.
  double fit(const Points & points, const Pose2 & pose, double least = 0.0) const;

private:
  void addWall(int column, int row);
  int valueAt(double x, double y) const;

  int columns_;
  int rows_;
  int reach_;  // cells
  double cells_per_metre_;
  std::vector<std::uint8_t> kernel_;
  std::vector<std::uint8_t> values_;
};
}  // namespace amcl
