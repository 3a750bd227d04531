#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <array>
#include <cstdint>
#include <vector>

#include "amcl/geometry.h"

namespace amcl
{
using Points = std::vector<Vec2>;

/// How well a beam fits that ends at some distance from a wall.
class Fit
{
public:
  /// @param slack      m from a wall that count as no distance
  /// @param deviation  m, standard deviation of the distance beyond that
  Fit(double slack, double deviation);

  /// @param distance  in the steps of a FitField, not negative
  int at(int distance) const { return values_[distance]; }

private:
  std::array<std::uint8_t, 128> values_;
};

class Walls;

/// Distances on a map to where walls begin.
class FitField
{
public:
  explicit FitField(const mrpt::maps::COccupancyGridMap2D & map);

  /// Mean fit of the ends of beams, which are in the frame of the pose: 0 to 1; 0 as soon as it is certain to be less
  /// than the least. Distances are those of the cells.
  double rough(const Fit & fit, const Points & points, const Pose2 & pose, double least = 0.0) const;
  /// The same with distances interpolated between the cells.
  double close(const Fit & fit, const Points & points, const Pose2 & pose, double least = 0.0) const;

private:
  std::int8_t & at(int column, int row) { return distances_[static_cast<std::size_t>(row) * columns_ + column]; }
  int at(int column, int row) const { return distances_[static_cast<std::size_t>(row) * columns_ + column]; }
  void tellFrom(const Walls & walls, int column, int row);
  int distanceAt(double x, double y) const;
  int distanceBetween(double x, double y) const;
  template <typename Distance>
  double mean(const Fit & fit, const Points & points, const Pose2 & pose, double least, Distance distance) const;

  int columns_;
  int rows_;
  double cells_per_metre_;
  std::vector<std::int8_t> distances_;  // below 0 inside of walls
};
}  // namespace amcl
