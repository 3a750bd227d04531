#pragma once

#include <cstdint>
#include <vector>

#include "move_base/map/geometry.h"

namespace move_base
{
/// How the costs that are shown fall with the distance from obstacles, as in the original's inflation layer.
struct Inflation
{
  double radius{0.55};               ///< m, beyond it obstacles cost nothing
  double cost_scaling_factor{10.0};  ///< 1/m
  double inscribed_radius{0.0};      ///< m, from the base frame to the nearest edge of the footprint
};

/// The costs of a grid as messages show them: 100 obstacle, 99 where the car surely touches one, falling to 0; -1 unknown.
/// @param cells  row by row: 100 obstacle, -1 unknown, else free; unknown cells cost what is at least 99
std::vector<std::int8_t> inflated(
  const std::vector<std::int8_t> & cells, const GridGeometry & geometry, const Inflation & inflation);

/// Puts more obstacles into costs that inflated() gave: as if they had been among its cells.
void addObstacles(OccupancyGrid & costs, const std::vector<Cell> & obstacles, const Inflation & inflation);
}  // namespace move_base
