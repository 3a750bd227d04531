#include "cell_map.h"

#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace gmapping
{
namespace
{
constexpr double kFirstSide = 20.0;  // m, of a new map; it need not be right
constexpr double kMargin = 5.0;      // m that a map grows by beyond what is needed, so that it grows rarely

std::int8_t occupancy(const MapCell & cell, double threshold)
{
  if (cell.visits == 0) {
    return -1;
  }
  return cell.occupied(threshold) ? 100 : 0;
}

int cellsBetween(double low, double high, double resolution)
{
  return static_cast<int>(std::lround((high - low) / resolution));
}
void expectRoom(double width, double height, double resolution)
{
  if (!(width / resolution * (height / resolution) <= kMostCells)) {
    std::ostringstream message;
    message << "map: found " << width << " m x " << height << " m of cells of " << resolution << " m, must be at most "
            << kMostCells << " cells";
    throw Error(message.str());
  }
}
}  // namespace

CellMap::CellMap(double resolution)
: resolution_(resolution), cells_(-0.5 * kFirstSide, 0.5 * kFirstSide, -0.5 * kFirstSide, 0.5 * kFirstSide, resolution)
{
}

void CellMap::grow(const Vec2 & centre, double reach)
{
  // A cell of margin, as a beam may end on the border.
  const double needed = reach + resolution_;
  expectRoom(
    std::max(cells_.getXMax(), centre.x + needed) - std::min(cells_.getXMin(), centre.x - needed),
    std::max(cells_.getYMax(), centre.y + needed) - std::min(cells_.getYMin(), centre.y - needed), resolution_);
  cells_.resize(centre.x - needed, centre.x + needed, centre.y - needed, centre.y + needed, MapCell{}, kMargin);
}

void CellMap::addBeam(const Vec2 & from, const Vec2 & to, bool is_hit)
{
  const Cell first = index(from);
  const Cell last = index(to);
  // Bresenham's line, the last cell left out.
  const int dx = std::abs(last.x - first.x);
  const int dy = std::abs(last.y - first.y);
  const int step_x = first.x < last.x ? 1 : -1;
  const int step_y = first.y < last.y ? 1 : -1;
  int error = dx - dy;
  for (Cell here = first; here.x != last.x || here.y != last.y;) {
    ++at(here).visits;
    const int doubled = 2 * error;
    if (doubled > -dy) {
      error -= dy;
      here.x += step_x;
    }
    if (doubled < dx) {
      error += dx;
      here.y += step_y;
    }
  }
  MapCell & end = at(last);
  ++end.visits;
  if (is_hit) {
    ++end.hits;
    end.sum_x += static_cast<float>(to.x - cells_.getXMin() - last.x * resolution_);
    end.sum_y += static_cast<float>(to.y - cells_.getYMin() - last.y * resolution_);
  }
}

OccupancyGrid CellMap::grid(const SlamOptions & options) const
{
  OccupancyGrid grid;
  grid.geometry.resolution = resolution_;
  // Whole cells beyond the map on each side.
  const int left = std::max(0, cellsBetween(options.xmin, cells_.getXMin(), resolution_));
  const int below = std::max(0, cellsBetween(options.ymin, cells_.getYMin(), resolution_));
  const int right = std::max(0, cellsBetween(cells_.getXMax(), options.xmax, resolution_));
  const int above = std::max(0, cellsBetween(cells_.getYMax(), options.ymax, resolution_));
  const int columns = static_cast<int>(cells_.getSizeX());
  const int rows = static_cast<int>(cells_.getSizeY());
  grid.geometry.origin.x = cells_.getXMin() - left * resolution_;
  grid.geometry.origin.y = cells_.getYMin() - below * resolution_;
  grid.geometry.width = left + columns + right;
  grid.geometry.height = below + rows + above;
  expectRoom(grid.geometry.width * resolution_, grid.geometry.height * resolution_, resolution_);
  grid.cells.assign(static_cast<std::size_t>(grid.geometry.width) * grid.geometry.height, -1);
  for (int y = 0; y < rows; ++y) {
    const MapCell * row = cells_.cellByIndex(0, y);
    std::transform(
      row, row + columns, grid.cells.begin() + static_cast<std::ptrdiff_t>(y + below) * grid.geometry.width + left,
      [&](const MapCell & cell) { return occupancy(cell, options.occ_thresh); });
  }
  return grid;
}
}  // namespace gmapping
