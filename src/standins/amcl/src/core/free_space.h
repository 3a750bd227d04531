#pragma once

#include <vector>

#include "amcl/geometry.h"

namespace amcl
{
/// Where a car that is lost may be: all free cells that can be reached from a place. If that place is not free itself,
/// all free cells: a map of a road is often free outside of the walls, too.
/// @param place  in the frame of the map
std::vector<Cell> freeCellsAbout(const OccupancyGrid & map, const Vec2 & place);
}  // namespace amcl
