#include "seen/live_layer.h"

#include <algorithm>
#include <cmath>

#include "geometry/option_checks.h"

namespace move_base
{
namespace
{
constexpr double kLeastTolerance = 1.5;  // cells
}  // namespace

void LiveLayerOptions::validate() const
{
  requirePositive("obstacle_range", obstacle_range);
  requirePositive("raytrace_range", raytrace_range);
  requireNotNegative("wall_tolerance", wall_tolerance);
}

// A beam that hits the corner of a wall's cell may end in the next but one.
LiveLayer::LiveLayer(const GridGeometry & geometry, const LiveLayerOptions & options)
: geometry_(geometry),
  options_(options),
  wall_tolerance_(std::max(options.wall_tolerance, kLeastTolerance * geometry.resolution)),
  marked_(geometry.size(), 0)
{
}

bool LiveLayer::observe(const LaserScan & scan, const std::vector<Vec2> & hits)
{
  const bool cleared = clear(scan);
  const bool marked = mark(hits);
  return cleared || marked;
}

bool LiveLayer::forgetBeyond(const Vec2 & centre, double radius)
{
  return forgetIf([&](const Vec2 & cell) { return distance(cell, centre) > radius; });
}

bool LiveLayer::forgetIn(const Box & outline)
{
  return forgetIf([&](const Vec2 & cell) { return outline.distanceTo(cell) <= 0.0; });
}

bool LiveLayer::clear(const LaserScan & scan)
{
  return forgetIf([&](const Vec2 & cell) { return seesThrough(scan, cell); });
}

bool LiveLayer::seesThrough(const LaserScan & scan, const Vec2 & point) const
{
  const Vec2 relative = point - scan.sensor.position();
  const double range = norm(relative);
  const double angle = normalizeAngle(std::atan2(relative.y, relative.x) - scan.sensor.yaw);
  const double beam = std::round((angle - scan.angle_min) / scan.angle_increment);
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
    const Vec2 hit = transform(scan.sensor, {range * std::cos(angle), range * std::sin(angle)});
    const Cell cell = geometry_.cellAt(hit);
    if (geometry_.contains(cell) && map_distances[geometry_.index(cell)] > wall_tolerance_) {
      hits.push_back(hit);
    }
  }
  return hits;
}

bool LiveLayer::mark(const std::vector<Vec2> & hits)
{
  const std::size_t before = cells_.size();
  for (const Vec2 & hit : hits) {
    const std::size_t index = geometry_.index(geometry_.cellAt(hit));
    if (marked_[index] == 0) {
      marked_[index] = 1;
      cells_.push_back(index);
    }
  }
  return cells_.size() != before;
}

template <class Predicate>
bool LiveLayer::forgetIf(Predicate predicate)
{
  const auto forgotten = std::remove_if(cells_.begin(), cells_.end(), [&](std::size_t index) {
    const bool forget = predicate(geometry_.centre(geometry_.cell(index)));
    if (forget) {
      marked_[index] = 0;
    }
    return forget;
  });
  const bool changed = forgotten != cells_.end();
  cells_.erase(forgotten, cells_.end());
  return changed;
}
}  // namespace move_base
