#pragma once

#include <cstdint>
#include <vector>

namespace move_base
{
/// Exact Euclidean distance of each cell's centre to that of the nearest marked cell, in cells (Felzenszwalb and
/// Huttenlocher, linear in the number of cells). Without a marked cell: width + height everywhere.
/// @param marked  row by row, non-zero where marked
std::vector<float> distanceTransform(const std::vector<std::uint8_t> & marked, int width, int height);
}  // namespace move_base
