#pragma once

#include "f1tenth_sim2d/loaders.h"

namespace f1tenth_sim2d
{
/// The occupied cells as walls, the lower left corner of the grid at the origin.
Polyline wallsOf(const MapGrid & grid, double height);
}  // namespace f1tenth_sim2d
