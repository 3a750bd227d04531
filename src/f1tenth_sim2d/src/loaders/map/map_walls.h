#pragma once

#include <cstdint>
#include <vector>

#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Which cells of a grid are occupied; row 0 is the lowest.
struct CellGrid
{
  std::size_t columns{0};
  std::size_t rows{0};
  std::vector<std::uint8_t> occupied;  ///< 1 or 0, row by row

  bool at(std::size_t column, std::size_t row) const { return occupied[row * columns + column] != 0; }
};

/// The occupied cells as walls, the lower left corner of the grid at the origin.
/// @param resolution  m, edge length of a cell
Polyline wallsOf(const CellGrid & grid, double resolution, double height);
}  // namespace f1tenth_sim2d
