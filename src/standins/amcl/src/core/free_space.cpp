#include "free_space.h"

namespace amcl
{
namespace
{
bool isFree(const OccupancyGrid & map, const Cell & cell)
{
  return map.geometry.contains(cell) && map.cells[map.geometry.index(cell)] == 0;
}

std::vector<Cell> reachable(const OccupancyGrid & map, const Cell & start)
{
  std::vector<bool> seen(map.cells.size());
  std::vector<Cell> cells;
  const auto visit = [&](const Cell & cell) {
    if (isFree(map, cell) && !seen[map.geometry.index(cell)]) {
      seen[map.geometry.index(cell)] = true;
      cells.push_back(cell);
    }
  };
  visit(start);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto [x, y] = cells[i];
    visit({x + 1, y});
    visit({x - 1, y});
    visit({x, y + 1});
    visit({x, y - 1});
  }
  return cells;
}

std::vector<Cell> allFree(const OccupancyGrid & map)
{
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    if (map.cells[i] == 0) {
      cells.push_back(map.geometry.cell(i));
    }
  }
  return cells;
}
}  // namespace

std::vector<Cell> freeCellsAbout(const OccupancyGrid & map, const Vec2 & place)
{
  GridGeometry local = map.geometry;
  local.origin = {};
  const std::vector<Cell> cells = reachable(map, local.cellAt(transform(inverse(map.geometry.origin), place)));
  return cells.empty() ? allFree(map) : cells;
}
}  // namespace amcl
