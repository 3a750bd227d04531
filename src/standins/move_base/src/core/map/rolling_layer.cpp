#include "map/rolling_layer.h"

#include <algorithm>
#include <cmath>

namespace move_base
{
namespace
{
constexpr std::int8_t kOccupied = 100;

int cellsIn(double length, double resolution)
{
  return std::max(1, static_cast<int>(length / resolution + 1e-6));
}
}  // namespace

RollingLayer::RollingLayer(double width, double height, double resolution, const LiveLayerOptions & options)
: options_(options)
{
  geometry_.resolution = resolution;
  geometry_.width = cellsIn(width, resolution);
  geometry_.height = cellsIn(height, resolution);
  cells_.assign(geometry_.size(), 0);
}

void RollingLayer::moveTo(const Vec2 & car)
{
  const auto along = [this](double middle, int cells, double origin) {
    return std::lround((middle - 0.5 * cells * geometry_.resolution - origin) / geometry_.resolution);
  };
  const auto right = along(car.x, geometry_.width, geometry_.origin.x);
  const auto up = along(car.y, geometry_.height, geometry_.origin.y);
  if (right == 0 && up == 0) {
    return;
  }
  std::vector<std::int8_t> moved(cells_.size(), 0);
  for (int y = 0; y < geometry_.height; ++y) {
    for (int x = 0; x < geometry_.width; ++x) {
      const Cell before{static_cast<int>(x + right), static_cast<int>(y + up)};
      if (geometry_.contains(before)) {
        moved[geometry_.index({x, y})] = cells_[geometry_.index(before)];
      }
    }
  }
  cells_ = std::move(moved);
  geometry_.origin.x += static_cast<double>(right) * geometry_.resolution;
  geometry_.origin.y += static_cast<double>(up) * geometry_.resolution;
}

void RollingLayer::observe(const LaserScan & scan)
{
  std::vector<Vec2> hits;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (!(range >= scan.range_min)) {
      continue;
    }
    const double angle = scan.sensor.yaw + scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Vec2 direction{maths::cos(angle), maths::sin(angle)};
    clearAlong(scan, direction, range);
    if (range <= std::min(options_.obstacle_range, scan.range_max)) {
      hits.push_back(scan.sensor.position() + range * direction);
    }
  }
  for (const Vec2 & hit : hits) {
    if (const Cell cell = geometry_.cellAt(hit); geometry_.contains(cell)) {
      cells_[geometry_.index(cell)] = kOccupied;
    }
  }
}

void RollingLayer::clearAlong(const LaserScan & scan, const Vec2 & direction, double range)
{
  const double step = 0.7 * geometry_.resolution;
  const double end = std::min(range, options_.raytrace_range);
  for (double way = 0.0; way < end; way += step) {
    const Cell cell = geometry_.cellAt(scan.sensor.position() + way * direction);
    if (!geometry_.contains(cell)) {
      return;
    }
    cells_[geometry_.index(cell)] = 0;
  }
}
}  // namespace move_base
