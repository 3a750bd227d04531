#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/lidar/range_raster.h"
#include "f1tenth_sim2d/section.h"

namespace f1tenth_sim2d
{
/// A box along the axes, m.
struct Bounds
{
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(const Vec2 & p)
  {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

/// Which items of a WallGrid one lidar has drawn: an item that reaches over several cells is drawn once per scan.
class DrawnItems
{
public:
  /// @param count  of all items
  explicit DrawnItems(std::size_t count) : scan_(count, 0) {}

  /// Before each scan.
  void beginScan();
  bool isFirstTime(std::uint32_t item)
  {
    const bool is_first = scan_[item] != current_;
    scan_[item] = current_;
    return is_first;
  }

private:
  std::vector<std::uint16_t> scan_;  ///< in which each item was last drawn
  std::uint16_t current_{0};
};

/// The walls that do not move, at the height of a lidar, in a uniform grid. A scan goes from the nearest cells to the
/// farthest and leaves out what is hidden behind what it has drawn, so that it costs what it sees. Never changes.
class WallGrid
{
public:
  explicit WallGrid(const Section & walls);

  std::size_t itemCount() const { return walls_.size() + circles_.size(); }

  /// Draws everything that the lidar can see into a scan. Allocates nothing.
  /// @param drawn  of itemCount() items, the lidar's own
  void draw(RangeRaster & raster, DrawnItems & drawn) const;

private:
  /// Items of a cell come in groups: walls along the axes by the side from which they are seen, in the order of their
  /// places across, so that those that turn their backs to a sensor are not looked at.
  enum Group : std::size_t
  {
    kFromLeft,  ///< towards -x
    kFromRight,
    kFromBelow,  ///< towards -y
    kFromAbove,
    kSlanting,
    kCircles,
    kGroups
  };
  /// A scan in the making.
  struct Drawing
  {
    RangeRaster & raster;
    DrawnItems & drawn;
    double sight;  ///< m, after the last ring
  };
  struct Wall
  {
    Vec2 a;
    Vec2 b;
  };
  struct CellRange
  {
    int first;
    int last;
  };

  void collect(const Section & walls);
  void layOut();
  Bounds boundsInRow(const Wall & wall, const Bounds & bounds, int row) const;
  /// The cells that an item lies in.
  template <typename Visit>
  void forEachCell(std::size_t item, const Bounds & bounds, Visit visit) const;
  CellRange cells(double low, double high, double origin, int count) const;
  void measureCells(const std::vector<Bounds> & bounds);
  Group groupOf(std::size_t item) const;
  void drawRing(int column, int row, int ring, const Drawing & drawing) const;
  static bool isOutOfSight(const Circle & extent, const Drawing & drawing);
  void drawCell(std::size_t cell, const Drawing & drawing) const;
  void drawBeyond(
    const std::vector<double> & places, double sensor, const std::uint32_t * begin, const Drawing & drawing) const;
  void drawWalls(std::uint32_t begin, std::uint32_t end, const Drawing & drawing) const;

  std::vector<Wall> walls_;
  std::vector<Circle> circles_;
  Vec2 origin_;
  double cell_size_{1.0};
  int column_count_{0};
  int row_count_{0};
  // Compressed rows: what lies in cell c in group g is items_[begin_[i]] ... items_[begin_[i + 1] - 1], i = c kGroups + g.
  // Item i is wall i, or circle i - walls_.size().
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> items_;
  // Ends of each of items_ that is a wall, to be streamed; 0 for a circle, and for some behind the last.
  std::vector<double> a_x_;
  std::vector<double> a_y_;
  std::vector<double> b_x_;
  std::vector<double> b_y_;
  std::vector<Circle> extents_;  ///< around what lies in a cell
};
}  // namespace f1tenth_sim2d
