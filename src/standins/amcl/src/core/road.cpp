#include "road.h"

#include <utility>

namespace amcl
{
namespace
{
using mrpt::maps::COccupancyGridMap2D;
using Cells = std::vector<std::pair<int, int>>;

constexpr float kLeastFreedom = 0.7F;  // probability of being free of a cell in which a car may be

bool isFree(const COccupancyGridMap2D & map, int x, int y)
{
  return map.getCell(x, y) > kLeastFreedom;  // false outside of the map
}

Cells reachable(const COccupancyGridMap2D & map, int x, int y)
{
  std::vector<bool> seen(static_cast<std::size_t>(map.getSizeX()) * map.getSizeY());
  Cells cells;
  const auto visit = [&](int column, int row) {
    const std::size_t index = static_cast<std::size_t>(row) * map.getSizeX() + column;
    if (isFree(map, column, row) && !seen[index]) {
      seen[index] = true;
      cells.emplace_back(column, row);
    }
  };
  visit(x, y);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto [column, row] = cells[i];
    visit(column + 1, row);
    visit(column - 1, row);
    visit(column, row + 1);
    visit(column, row - 1);
  }
  return cells;
}

Cells allFree(const COccupancyGridMap2D & map)
{
  Cells cells;
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y) {
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x) {
      if (isFree(map, x, y)) {
        cells.emplace_back(x, y);
      }
    }
  }
  return cells;
}
}  // namespace

Points roadAbout(const COccupancyGridMap2D & map, const Pose2 & place)
{
  Cells cells = reachable(map, map.x2idx(place.x), map.y2idx(place.y));
  if (cells.empty()) {
    cells = allFree(map);
  }
  Points road;
  road.reserve(cells.size());
  for (const auto & [x, y] : cells) {
    road.push_back({map.idx2x(x), map.idx2y(y)});
  }
  return road;
}
}  // namespace amcl
