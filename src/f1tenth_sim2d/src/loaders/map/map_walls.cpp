#include "loaders/map/map_walls.h"

#include <algorithm>
#include <boost/polygon/polygon.hpp>

namespace f1tenth_sim2d
{
namespace
{
using Cells = boost::polygon::polygon_90_set_data<int>;  // in cells, so that nothing is rounded
using Polygon = boost::polygon::polygon_90_with_holes_data<int>;
using Block = boost::polygon::rectangle_data<int>;

Cells occupiedCells(const MapGrid & grid)
{
  Cells cells;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const auto left = static_cast<int>(column);
      while (column < grid.columns && grid.isOccupied(column, row)) {
        ++column;
      }
      const auto right = static_cast<int>(column);
      const auto bottom = static_cast<int>(row);
      if (left < right) {
        cells.insert(Block(left, bottom, right, bottom + 1));
      }
    }
  }
  return cells;
}

/// With matter to the left, as in Boost.
template <typename Corners>
Outline outlineOf(const Corners & corners, double resolution)
{
  Outline outline;
  std::for_each(corners.begin(), corners.end(), [&](const auto & corner) {
    outline.push_back({corner.x() * resolution, corner.y() * resolution});
  });
  return outline;
}
}  // namespace

Polyline wallsOf(const MapGrid & grid, double height)
{
  const Cells cells = occupiedCells(grid);
  std::vector<Polygon> polygons;
  cells.get(polygons);
  std::vector<Block> blocks;
  cells.get_rectangles(blocks);
  Polyline walls;
  walls.height = height;
  for (const Polygon & polygon : polygons) {
    walls.outlines.push_back(outlineOf(polygon, grid.resolution));
    std::for_each(polygon.begin_holes(), polygon.end_holes(), [&](const auto & hole) {
      walls.outlines.push_back(outlineOf(hole, grid.resolution));
    });
  }
  for (const Block & block : blocks) {
    const Vec2 low{xl(block) * grid.resolution, yl(block) * grid.resolution};
    const Vec2 high{xh(block) * grid.resolution, yh(block) * grid.resolution};
    walls.pieces.push_back({low, {high.x, low.y}, high, {low.x, high.y}});
  }
  return walls;
}
}  // namespace f1tenth_sim2d
