#include "core/lidar/wall_grid.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace f1tenth_sim2d
{
namespace
{
// A cell is worth checking if it holds some 20 walls; but one that is very large hides nothing, and many small ones
// take long to check.
constexpr double kItemsPerCell = 20.0;
constexpr double kCellSizeMin = 0.5;   // m
constexpr double kCellSizeMax = 5.0;   // m
constexpr double kCellCountMax = 1e6;  // in very large worlds the cells grow instead
constexpr double kRounding = 1e-9;     // m
constexpr double kBorder = 1e-6;       // of a cell: a wall nearer than that to its border lies in the next one, too
constexpr std::uint32_t kLanes = 4;    // walls of a vector: rather some of the next group than a rest
constexpr std::uint32_t kFew = 16;     // items: drawing so few is faster than finding out whether they show

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

void DrawnItems::beginScan()
{
  if (++current_ == 0) {
    std::fill(scan_.begin(), scan_.end(), 0);
    current_ = 1;
  }
}

WallGrid::WallGrid(const Section & walls)
{
  collect(walls);
  if (!walls_.empty() || !circles_.empty()) {
    layOut();
  }
}

void WallGrid::collect(const Section & walls)
{
  for (const Outline & outline : walls.outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      walls_.push_back({outline[i], outline[(i + 1) % outline.size()]});
    }
  }
  circles_ = walls.circles;
  const auto place = [](const Wall & wall) { return wall.a.x == wall.b.x ? wall.a.x : wall.a.y; };
  std::stable_sort(
    walls_.begin(), walls_.end(), [&](const Wall & one, const Wall & other) { return place(one) < place(other); });
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
  const double wanted = std::sqrt(kItemsPerCell * width * height / static_cast<double>(bounds.size()));
  cell_size_ = std::max(std::clamp(wanted, kCellSizeMin, kCellSizeMax), std::sqrt(width * height / kCellCountMax));
  column_count_ = static_cast<int>(width / cell_size_) + 1;
  row_count_ = static_cast<int>(height / cell_size_) + 1;

  const std::size_t cell_count = static_cast<std::size_t>(column_count_) * row_count_;
  begin_.assign(cell_count * kGroups + 1, 0);
  for (std::size_t item = 0; item < bounds.size(); ++item) {
    const Group group = groupOf(item);
    forEachCell(item, bounds[item], [&](std::size_t cell) { ++begin_[cell * kGroups + group + 1]; });
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  items_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t item = 0; item < bounds.size(); ++item) {
    const Group group = groupOf(item);
    forEachCell(item, bounds[item], [&](std::size_t cell) {
      items_[next[cell * kGroups + group]++] = static_cast<std::uint32_t>(item);
    });
  }
  for (const std::uint32_t item : items_) {
    const Wall wall = item < walls_.size() ? walls_[item] : Wall{};
    a_x_.push_back(wall.a.x);
    a_y_.push_back(wall.a.y);
    b_x_.push_back(wall.b.x);
    b_y_.push_back(wall.b.y);
  }
  for (std::vector<double> * ends : {&a_x_, &a_y_, &b_x_, &b_y_}) {
    ends->resize(items_.size() + kLanes);
  }
  measureCells(bounds);
}

WallGrid::Group WallGrid::groupOf(std::size_t item) const
{
  if (item >= walls_.size()) {
    return kCircles;
  }
  const Vec2 edge = walls_[item].b - walls_[item].a;
  if ((edge.x == 0.0) == (edge.y == 0.0)) {
    return kSlanting;
  }
  if (edge.x == 0.0) {
    return edge.y > 0.0 ? kFromRight : kFromLeft;
  }
  return edge.x > 0.0 ? kFromBelow : kFromAbove;
}

// What lies in a cell, as a circle: the bounds of its items, cut off at the cell.
void WallGrid::measureCells(const std::vector<Bounds> & bounds)
{
  extents_.resize(begin_.size() / kGroups);
  for (std::size_t cell = 0; cell < extents_.size(); ++cell) {
    const std::size_t column = cell % column_count_;
    const std::size_t row = cell / column_count_;
    const double x = origin_.x + static_cast<double>(column) * cell_size_;
    const double y = origin_.y + static_cast<double>(row) * cell_size_;
    Bounds all;
    for (std::uint32_t i = begin_[cell * kGroups]; i < begin_[(cell + 1) * kGroups]; ++i) {
      all.include(bounds[items_[i]].low);
      all.include(bounds[items_[i]].high);
    }
    const Vec2 low{std::max(all.low.x, x), std::max(all.low.y, y)};
    const Vec2 high{std::min(all.high.x, x + cell_size_), std::min(all.high.y, y + cell_size_)};
    const double diameter = maths::hypot(high.x - low.x, high.y - low.y);
    extents_[cell] = {{0.5 * (low.x + high.x), 0.5 * (low.y + high.y)}, 0.5 * diameter + kRounding};
  }
}

WallGrid::CellRange WallGrid::cells(double low, double high, double origin, int count) const
{
  const double last = count - 1;
  return {
    static_cast<int>(std::clamp(std::floor((low - origin) / cell_size_), 0.0, last)),
    static_cast<int>(std::clamp(std::floor((high - origin) / cell_size_), -1.0, last))};
}

// A long diagonal wall passes through few of the cells within its bounds.
Bounds WallGrid::boundsInRow(const Wall & wall, const Bounds & bounds, int row) const
{
  const double rise = wall.b.y - wall.a.y;
  if (rise == 0.0) {
    return bounds;
  }
  const double margin = kBorder * cell_size_;
  const double low = origin_.y + row * cell_size_ - margin;
  const double high = origin_.y + (row + 1) * cell_size_ + margin;
  Bounds part;
  for (const double y : {low, high}) {
    const double share = std::clamp((y - wall.a.y) / rise, 0.0, 1.0);
    const double x = wall.a.x + share * (wall.b.x - wall.a.x);
    part.include({std::max(bounds.low.x, x - margin), low});
    part.include({std::min(bounds.high.x, x + margin), high});
  }
  return part;
}

template <typename Visit>
void WallGrid::forEachCell(std::size_t item, const Bounds & bounds, Visit visit) const
{
  const CellRange rows = cells(bounds.low.y, bounds.high.y, origin_.y, row_count_);
  for (int row = rows.first; row <= rows.last; ++row) {
    const Bounds part = item < walls_.size() ? boundsInRow(walls_[item], bounds, row) : bounds;
    const CellRange columns = cells(part.low.x, part.high.x, origin_.x, column_count_);
    for (int column = columns.first; column <= columns.last; ++column) {
      visit(static_cast<std::size_t>(row) * column_count_ + column);
    }
  }
}

void WallGrid::draw(RangeRaster & raster, DrawnItems & drawn) const
{
  if (items_.empty()) {
    return;
  }
  drawn.beginScan();
  const Transform2 & sensor = raster.sensor();
  const Vec2 here{(sensor.x - origin_.x) / cell_size_, (sensor.y - origin_.y) / cell_size_};
  const int rings = static_cast<int>(raster.rangeMax() / cell_size_) + 1;
  if (here.x < -rings || here.y < -rings || here.x > column_count_ + rings || here.y > row_count_ + rings) {
    return;
  }
  const int column = static_cast<int>(std::floor(here.x));
  const int row = static_cast<int>(std::floor(here.y));
  const int last_ring =
    std::min(rings, std::max({column, column_count_ - 1 - column, row, row_count_ - 1 - row}));  // with a cell in it
  // What lies beyond ring n - 1 is farther than the nearest of its four sides.
  const double to_side = std::min({here.x - column, column + 1 - here.x, here.y - row, row + 1 - here.y}) * cell_size_;
  Drawing drawing{raster, drawn, raster.rangeMax()};
  for (int ring = 0; ring <= last_ring && (ring == 0 || to_side + (ring - 1) * cell_size_ <= drawing.sight); ++ring) {
    drawRing(column, row, ring, drawing);
    drawing.sight = raster.sight();
  }
}

// The cells that are `ring` columns or rows away from a cell.
void WallGrid::drawRing(int column, int row, int ring, const Drawing & drawing) const
{
  const int left = std::max(column - ring, 0);
  const int right = std::min(column + ring, column_count_ - 1);
  const int bottom = std::max(row - ring, 0);
  const int top = std::min(row + ring, row_count_ - 1);
  for (int r = bottom; r <= top; ++r) {
    const bool is_whole_row = r == row - ring || r == row + ring;
    const int step = is_whole_row || ring == 0 ? 1 : 2 * ring;
    for (int c = is_whole_row ? left : column - ring; c <= right; c += step) {
      if (c >= left) {
        drawCell(static_cast<std::size_t>(r) * column_count_ + c, drawing);
      }
    }
  }
}

bool WallGrid::isOutOfSight(const Circle & extent, const Drawing & drawing)
{
  const Transform2 & sensor = drawing.raster.sensor();
  const double x = extent.centre.x - sensor.x;
  const double y = extent.centre.y - sensor.y;
  const double reach = drawing.sight + extent.radius;
  return x * x + y * y > reach * reach;
}

void WallGrid::drawCell(std::size_t cell, const Drawing & drawing) const
{
  const std::uint32_t * const begin = &begin_[cell * kGroups];
  const std::uint32_t count = begin[kGroups] - begin[0];
  if (count == 0 || isOutOfSight(extents_[cell], drawing)) {
    return;
  }
  RangeRaster & raster = drawing.raster;
  if (count > kFew && !raster.couldShow(extents_[cell].centre, extents_[cell].radius)) {
    return;
  }
  drawBeyond(a_x_, raster.sensor().x, begin + kFromLeft, drawing);
  drawBeyond(a_y_, raster.sensor().y, begin + kFromBelow, drawing);
  drawWalls(begin[kSlanting], begin[kCircles], drawing);
  for (std::uint32_t i = begin[kCircles]; i < begin[kGroups]; ++i) {
    if (drawing.drawn.isFirstTime(items_[i])) {
      const Circle & circle = circles_[items_[i] - walls_.size()];
      raster.addCircle(circle.centre, circle.radius);
    }
  }
}

// Of two groups of walls, seen from low places and from high ones, those that are seen from the sensor's.
void WallGrid::drawBeyond(
  const std::vector<double> & places, double sensor, const std::uint32_t * begin, const Drawing & drawing) const
{
  const double * const all = places.data();
  const double * const first = std::upper_bound(all + begin[0], all + begin[1], sensor);
  const double * const end = std::lower_bound(all + begin[1], all + begin[2], sensor);
  drawWalls(static_cast<std::uint32_t>(first - all), static_cast<std::uint32_t>(end - all), drawing);
}

void WallGrid::drawWalls(std::uint32_t begin, std::uint32_t end, const Drawing & drawing) const
{
  constexpr auto kMost = static_cast<std::uint32_t>(SeenWalls::kMost);
  for (std::uint32_t i = begin; i < end; i += kMost) {
    const std::uint32_t whole = (end - i + kLanes - 1) / kLanes * kLanes;
    drawing.raster.addWalls({&a_x_[i], &a_y_[i], &b_x_[i], &b_y_[i]}, std::min(kMost, whole), [&](std::size_t wall) {
      return drawing.drawn.isFirstTime(items_[i + wall]);
    });
  }
}
}  // namespace f1tenth_sim2d
