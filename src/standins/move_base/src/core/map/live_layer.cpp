#include "move_base/map/live_layer.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace move_base
{
namespace
{
constexpr double kWallTolerance = 0.12;  // m
constexpr double kLeastTolerance = 1.5;  // cells
}  // namespace

void LiveLayerOptions::validate() const
{
  requirePositive("obstacle_range", obstacle_range);
  requirePositive("raytrace_range", raytrace_range);
}

// A beam that hits the corner of a wall's cell may end in the next but one.
LiveLayer::LiveLayer(const GridGeometry & geometry, const LiveLayerOptions & options)
: geometry_(geometry),
  options_(options),
  wall_tolerance_(std::max(kWallTolerance, kLeastTolerance * geometry.resolution))
{
}

bool LiveLayer::observe(const LaserScan & scan, const std::vector<Vec2> & places)
{
  const bool cleared = forgetIf([&](const Vec2 & cell) { return seesThrough(scan, cell); });
  const std::size_t before = cells_.size();
  for (const Vec2 & place : places) {
    cells_.insert(geometry_.index(geometry_.cellAt(place)));
  }
  return cleared || cells_.size() != before;
}

bool LiveLayer::seesThrough(const LaserScan & scan, const Vec2 & place) const
{
  const Vec2 relative = place - scan.sensor.position();
  const double range = norm(relative);
  const double angle = normalizeAngle(maths::atan2(relative.y, relative.x) - scan.sensor.yaw);
  const double full_turn = std::round(2.0 * M_PI / std::abs(scan.angle_increment));
  double beam = std::round((angle - scan.angle_min) / scan.angle_increment);
  beam += beam < 0.0 ? full_turn : 0.0;
  if (range > options_.raytrace_range || beam < 0.0 || beam >= static_cast<double>(scan.ranges.size())) {
    return false;
  }
  const double seen = scan.ranges[static_cast<std::size_t>(beam)];
  return seen >= scan.range_min && seen > range + geometry_.resolution && range < scan.range_max;
}

std::vector<Vec2> LiveLayer::hits(const LaserScan & scan, const std::vector<float> & map_distances) const
{
  std::vector<Vec2> hits;
  const double limit = std::min(options_.obstacle_range, scan.range_max);
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const double range = scan.ranges[i];
    if (!(range >= scan.range_min && range <= limit)) {
      continue;
    }
    const double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment;
    const Vec2 hit = transform(scan.sensor, {range * maths::cos(angle), range * maths::sin(angle)});
    const Cell cell = geometry_.cellAt(hit);
    if (geometry_.contains(cell) && map_distances[geometry_.index(cell)] > wall_tolerance_) {
      hits.push_back(hit);
    }
  }
  return hits;
}

bool LiveLayer::forgetIf(const std::function<bool(const Vec2 &)> & is_over)
{
  const std::size_t before = cells_.size();
  for (auto cell = cells_.begin(); cell != cells_.end();) {
    cell = is_over(geometry_.centre(geometry_.cell(*cell))) ? cells_.erase(cell) : std::next(cell);
  }
  return cells_.size() != before;
}
}  // namespace move_base
