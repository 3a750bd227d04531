#pragma once

#include <cstdint>
#include <vector>

#include "amcl/geometry.h"

namespace amcl
{
/// A map as nav_msgs/OccupancyGrid has it: row by row from the lower left corner.
struct OccupancyGrid
{
  double resolution{0.0};          ///< m per cell
  Pose2 origin;                    ///< lower left corner and direction of the rows, in the map frame
  int width{0};                    ///< cells
  int height{0};                   ///< cells
  std::vector<std::int8_t> cells;  ///< 0 free, 100 occupied, anything else unknown
};
}  // namespace amcl
