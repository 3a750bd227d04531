#include "loaders/map/map_walls.h"

#include <algorithm>

namespace f1tenth_sim2d
{
namespace
{
/// A corner of cells.
struct Node
{
  std::size_t x;
  std::size_t y;
};

/// Follows the edges between occupied and free cells, matter to the left.
class BoundaryTracer
{
public:
  explicit BoundaryTracer(const CellGrid & grid)
  : grid_(grid), columns_(grid.columns + 1), edges_(columns_ * (grid.rows + 1), 0)
  {
    for (std::size_t y = 0; y <= grid.rows; ++y) {
      for (std::size_t x = 0; x <= grid.columns; ++x) {
        edges_[y * columns_ + x] = edgesFrom(x, y);
      }
    }
  }

  /// Every closed boundary has an edge that runs to the east.
  std::vector<std::vector<Node>> trace()
  {
    std::vector<std::vector<Node>> loops;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      while ((edges_[i] & bit(kEast)) != 0) {
        loops.push_back(follow({i % columns_, i / columns_}));
      }
    }
    return loops;
  }

private:
  static constexpr int kEast = 0;
  static constexpr int kNorth = 1;
  static constexpr int kWest = 2;
  static constexpr int kSouth = 3;
  static constexpr std::uint8_t bit(int direction) { return static_cast<std::uint8_t>(1 << direction); }

  bool occupied(std::size_t x, std::size_t y) const { return x < grid_.columns && y < grid_.rows && grid_.at(x, y); }

  // x - 1 of the first column wraps around to beyond the last one, which is free as well.
  std::uint8_t edgesFrom(std::size_t x, std::size_t y) const
  {
    const bool north_east = occupied(x, y);
    const bool north_west = occupied(x - 1, y);
    const bool south_east = occupied(x, y - 1);
    const bool south_west = occupied(x - 1, y - 1);
    int edges = 0;
    edges |= north_east && !south_east ? bit(kEast) : 0;
    edges |= north_west && !north_east ? bit(kNorth) : 0;
    edges |= south_west && !north_west ? bit(kWest) : 0;
    edges |= south_east && !south_west ? bit(kSouth) : 0;
    return static_cast<std::uint8_t>(edges);
  }

  bool take(const Node & node, int direction)
  {
    std::uint8_t & edges = edges_[node.y * columns_ + node.x];
    const bool there = (edges & bit(direction)) != 0;
    edges = static_cast<std::uint8_t>(edges & ~bit(direction));
    return there;
  }

  // To the left first: cells that touch at a corner only do not hang together.
  std::vector<Node> follow(Node node)
  {
    std::vector<Node> corners;
    int direction = kEast;
    int last = -1;
    while (take(node, direction)) {
      if (direction != last) {
        corners.push_back(node);
      }
      last = direction;
      node.x += direction == kEast ? 1 : direction == kWest ? -1 : 0;
      node.y += direction == kNorth ? 1 : direction == kSouth ? -1 : 0;
      const std::uint8_t edges = edges_[node.y * columns_ + node.x];
      for (const int turn : {1, 0, 3}) {
        if ((edges & bit((last + turn) % 4)) != 0) {
          direction = (last + turn) % 4;
          break;
        }
      }
    }
    return corners;
  }

  const CellGrid & grid_;
  std::size_t columns_;
  std::vector<std::uint8_t> edges_;  ///< by node: which directions a boundary leaves in
};

struct CellBlock
{
  std::size_t left;
  std::size_t bottom;
  std::size_t right;
  std::size_t top;
};

/// Disjoint rectangles that fill the occupied cells: runs of a row, each grown upwards as far as it goes.
std::vector<CellBlock> blocksOf(CellGrid grid)
{
  const auto runEnd = [&](std::size_t x, std::size_t y) {
    while (x < grid.columns && grid.at(x, y)) {
      ++x;
    }
    return x;
  };
  std::vector<CellBlock> blocks;
  for (std::size_t y = 0; y < grid.rows; ++y) {
    for (std::size_t x = 0; x < grid.columns; ++x) {
      if (!grid.at(x, y)) {
        continue;
      }
      CellBlock block{x, y, runEnd(x, y), y};
      while (block.top < grid.rows && runEnd(x, block.top) >= block.right) {
        std::fill_n(grid.occupied.begin() + block.top * grid.columns + x, block.right - x, std::uint8_t{0});
        ++block.top;
      }
      blocks.push_back(block);
    }
  }
  return blocks;
}
}  // namespace

Polyline wallsOf(const CellGrid & grid, double resolution, double height)
{
  const auto point = [&](std::size_t x, std::size_t y) {
    return Vec2{static_cast<double>(x) * resolution, static_cast<double>(y) * resolution};
  };
  Polyline walls;
  walls.height = height;
  for (const std::vector<Node> & loop : BoundaryTracer(grid).trace()) {
    Outline & outline = walls.outlines.emplace_back();
    for (const Node & node : loop) {
      outline.push_back(point(node.x, node.y));
    }
  }
  for (const CellBlock & block : blocksOf(grid)) {
    walls.pieces.push_back(
      {point(block.left, block.bottom), point(block.right, block.bottom), point(block.right, block.top),
       point(block.left, block.top)});
  }
  return walls;
}
}  // namespace f1tenth_sim2d
