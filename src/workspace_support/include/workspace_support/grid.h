#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "workspace_support/planar.h"

namespace workspace_support
{
/// Column and row of a cell; (0, 0) is at the origin.
struct Cell
{
  int x{0};
  int y{0};
};

/// Where the cells of a grid lie.
struct GridGeometry
{
  int width{0};            ///< cells along x
  int height{0};           ///< cells along y
  double resolution{0.0};  ///< m, edge of a cell
  Pose2 origin;            ///< outer corner of cell (0, 0) and direction of the rows, in the map frame

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  bool contains(const Cell & cell) const { return cell.x >= 0 && cell.y >= 0 && cell.x < width && cell.y < height; }
  std::size_t index(const Cell & cell) const
  {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cell.x);
  }
  Cell cell(std::size_t index) const
  {
    const auto columns = static_cast<std::size_t>(width);
    return {static_cast<int>(index % columns), static_cast<int>(index / columns)};
  }
  /// The cell in which a point lies, which may be outside of the grid. For a grid that is not rotated.
  Cell cellAt(const Vec2 & point) const
  {
    return {
      static_cast<int>(std::floor((point.x - origin.x) / resolution)),
      static_cast<int>(std::floor((point.y - origin.y) / resolution))};
  }
  /// For a grid that is not rotated.
  Vec2 centre(const Cell & cell) const
  {
    return {origin.x + (cell.x + 0.5) * resolution, origin.y + (cell.y + 0.5) * resolution};
  }
};

/// A map as in nav_msgs/OccupancyGrid: 0 free, 100 occupied, values between them in percent, -1 unknown; row by row
/// from the origin.
struct OccupancyGrid
{
  GridGeometry geometry;
  std::vector<std::int8_t> cells;
};
}  // namespace workspace_support
