#pragma once

#include <cstdint>
#include <vector>

#include "f1tenth_sim2d/section.h"
#include "range_raster.h"

namespace f1tenth_sim2d
{
/// The walls that do not move, at the height of a lidar: a uniform grid, so that a scan looks only at what is near.
class WallGrid
{
public:
  explicit WallGrid(const Section & walls);

  /// Draws everything within the lidar's range into a scan. Allocates nothing.
  void draw(RangeRaster & raster);

private:
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
  template <typename Visit>
  void forEachCell(const Vec2 & low, const Vec2 & high, Visit visit) const;
  CellRange columns(double low, double high) const;
  CellRange rows(double low, double high) const;
  bool isOutOfRange(int column, int row, const RangeRaster & raster) const;
  void drawCell(std::size_t cell, RangeRaster & raster);

  std::vector<Wall> walls_;
  std::vector<Circle> circles_;
  Vec2 origin_;
  double cell_size_{1.0};
  int column_count_{0};
  int row_count_{0};
  // Compressed rows: what lies in cell c is items_[begin_[c]] ... items_[begin_[c + 1] - 1].
  // Item i is wall i, or circle i - walls_.size().
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> items_;
  // An item that reaches over several cells is drawn once a scan: when it was drawn last.
  std::vector<std::uint32_t> drawn_;
  std::uint32_t scan_number_{0};
};
}  // namespace f1tenth_sim2d
