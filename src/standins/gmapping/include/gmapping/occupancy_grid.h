#pragma once

#include <cstdint>
#include <vector>

namespace gmapping
{
/// A map as nav_msgs/OccupancyGrid has it: row by row from the lower left corner.
struct OccupancyGrid
{
  double resolution{0.0};          ///< m per cell
  double x{0.0};                   ///< m, lower left corner
  double y{0.0};                   ///< m
  int width{0};                    ///< cells
  int height{0};                   ///< cells
  std::vector<std::int8_t> cells;  ///< -1 unknown, 0 free, 100 occupied
};
}  // namespace gmapping
