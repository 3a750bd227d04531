#include "wall_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
constexpr double kCellSize = 2.0;      // m
constexpr double kCellCountMax = 1e6;  // in very large worlds the cells grow instead

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

template <typename Wall>
Bounds boundsOf(const Wall & wall)
{
  Bounds bounds;
  bounds.include(wall.a);
  bounds.include(wall.b);
  return bounds;
}

Bounds boundsOf(const Circle & circle)
{
  Bounds bounds;
  bounds.include({circle.centre.x - circle.radius, circle.centre.y - circle.radius});
  bounds.include({circle.centre.x + circle.radius, circle.centre.y + circle.radius});
  return bounds;
}
}  // namespace

WallGrid::WallGrid(const Section & walls)
{
  collect(walls);
  if (!walls_.empty() || !circles_.empty()) {
    layOut();
  }
  drawn_.assign(walls_.size() + circles_.size(), 0);
}

void WallGrid::collect(const Section & walls)
{
  for (const Outline & outline : walls.outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      walls_.push_back({outline[i], outline[(i + 1) % outline.size()]});
    }
  }
  circles_ = walls.circles;
}

void WallGrid::layOut()
{
  std::vector<Bounds> bounds;
  for (const Wall & wall : walls_) {
    bounds.push_back(boundsOf(wall));
  }
  for (const Circle & circle : circles_) {
    bounds.push_back(boundsOf(circle));
  }
  Bounds all;
  for (const Bounds & b : bounds) {
    all.include(b.low);
    all.include(b.high);
  }
  const double width = all.high.x - all.low.x;
  const double height = all.high.y - all.low.y;
  origin_ = all.low;
  cell_size_ = std::max(kCellSize, std::sqrt(width * height / kCellCountMax));
  column_count_ = static_cast<int>(width / cell_size_) + 1;
  row_count_ = static_cast<int>(height / cell_size_) + 1;

  const std::size_t cell_count = static_cast<std::size_t>(column_count_) * row_count_;
  begin_.assign(cell_count + 1, 0);
  for (const Bounds & b : bounds) {
    forEachCell(b.low, b.high, [&](std::size_t cell) { ++begin_[cell + 1]; });
  }
  for (std::size_t cell = 0; cell < cell_count; ++cell) {
    begin_[cell + 1] += begin_[cell];
  }
  items_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t item = 0; item < bounds.size(); ++item) {
    forEachCell(bounds[item].low, bounds[item].high, [&](std::size_t cell) {
      items_[next[cell]++] = static_cast<std::uint32_t>(item);
    });
  }
}

WallGrid::CellRange WallGrid::columns(double low, double high) const
{
  const double last = column_count_ - 1;
  return {
    static_cast<int>(std::clamp(std::floor((low - origin_.x) / cell_size_), 0.0, last)),
    static_cast<int>(std::clamp(std::floor((high - origin_.x) / cell_size_), -1.0, last))};
}

WallGrid::CellRange WallGrid::rows(double low, double high) const
{
  const double last = row_count_ - 1;
  return {
    static_cast<int>(std::clamp(std::floor((low - origin_.y) / cell_size_), 0.0, last)),
    static_cast<int>(std::clamp(std::floor((high - origin_.y) / cell_size_), -1.0, last))};
}

template <typename Visit>
void WallGrid::forEachCell(const Vec2 & low, const Vec2 & high, Visit visit) const
{
  const CellRange column_range = columns(low.x, high.x);
  const CellRange row_range = rows(low.y, high.y);
  for (int row = row_range.first; row <= row_range.last; ++row) {
    for (int column = column_range.first; column <= column_range.last; ++column) {
      visit(static_cast<std::size_t>(row) * column_count_ + column);
    }
  }
}

bool WallGrid::isOutOfRange(int column, int row, const RangeRaster & raster) const
{
  const double low_x = origin_.x + column * cell_size_;
  const double low_y = origin_.y + row * cell_size_;
  const Transform2 & sensor = raster.sensor();
  const double dx = sensor.x - std::clamp(sensor.x, low_x, low_x + cell_size_);
  const double dy = sensor.y - std::clamp(sensor.y, low_y, low_y + cell_size_);
  return dx * dx + dy * dy > raster.rangeMax() * raster.rangeMax();
}

void WallGrid::draw(RangeRaster & raster)
{
  if (items_.empty()) {
    return;
  }
  if (++scan_number_ == 0) {
    std::fill(drawn_.begin(), drawn_.end(), 0);
    scan_number_ = 1;
  }
  const Transform2 & sensor = raster.sensor();
  const double range = raster.rangeMax();
  const CellRange column_range = columns(sensor.x - range, sensor.x + range);
  const CellRange row_range = rows(sensor.y - range, sensor.y + range);
  for (int row = row_range.first; row <= row_range.last; ++row) {
    for (int column = column_range.first; column <= column_range.last; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * column_count_ + column;
      if (begin_[cell] != begin_[cell + 1] && !isOutOfRange(column, row, raster)) {
        drawCell(cell, raster);
      }
    }
  }
}

void WallGrid::drawCell(std::size_t cell, RangeRaster & raster)
{
  for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
    const std::uint32_t item = items_[i];
    if (drawn_[item] == scan_number_) {
      continue;
    }
    drawn_[item] = scan_number_;
    if (item < walls_.size()) {
      raster.addSegment(walls_[item].a, walls_[item].b);
    } else {
      const Circle & circle = circles_[item - walls_.size()];
      raster.addCircle(circle.centre, circle.radius);
    }
  }
}
}  // namespace f1tenth_sim2d
