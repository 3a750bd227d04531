#include "move_base/map/live_layer.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace move_base
{
namespace
{
constexpr double kLeastTolerance = 1.5;  // cells
constexpr double kSameHeld = 0.3;        // m
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
  wall_tolerance_(std::max(options.wall_tolerance, kLeastTolerance * geometry.resolution))
{
}

bool LiveLayer::observe(const LaserScan & scan, const std::vector<Vec2> & hits)
{
  const bool cleared = clear(scan);
  const std::size_t before = cells_.size();
  for (const Vec2 & hit : hits) {
    cells_.insert(geometry_.index(geometry_.cellAt(hit)));
  }
  return cleared || cells_.size() != before;
}

bool LiveLayer::forgetBeyond(const Vec2 & centre, double radius)
{
  forgetHeldIf([&](const Vec2 & seen) { return distance(seen, centre) > radius; });
  return forgetIf([&](const Vec2 & cell) { return distance(cell, centre) > radius; });
}

bool LiveLayer::forgetIn(const Box & outline)
{
  forgetHeldIf([&](const Vec2 & seen) { return outline.distanceTo(seen) <= 0.0; });
  return forgetIf([&](const Vec2 & cell) { return outline.distanceTo(cell) <= 0.0; });
}

bool LiveLayer::clear(const LaserScan & scan)
{
  forgetHeldIf([&](const Vec2 & seen) { return seesThrough(scan, seen); });
  return forgetIf([&](const Vec2 & cell) { return seesThrough(scan, cell) && !isHeld(cell); });
}

bool LiveLayer::hold(const HeldOutline & held)
{
  const auto same = [&](const HeldOutline & known) { return distance(known.seen, held.seen) < kSameHeld; };
  if (std::any_of(held_.begin(), held_.end(), same)) {
    return false;
  }
  held_.push_back(held);
  const Box & outline = held.outline;
  const Vec2 reach = (outline.half_length + outline.half_width) * Vec2{1.0, 1.0};
  const Cell low = geometry_.cellAt(outline.middle.position() - reach);
  const Cell high = geometry_.cellAt(outline.middle.position() + reach);
  for (Cell cell{0, low.y}; cell.y <= high.y; ++cell.y) {
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      if (geometry_.contains(cell) && outline.distanceTo(geometry_.centre(cell)) <= 0.0) {
        cells_.insert(geometry_.index(cell));
      }
    }
  }
  return true;
}

bool LiveLayer::isHeld(const Vec2 & point) const
{
  return std::any_of(
    held_.begin(), held_.end(), [&](const auto & each) { return each.outline.distanceTo(point) <= 0.0; });
}

bool LiveLayer::seesThrough(const LaserScan & scan, const Vec2 & point) const
{
  const Vec2 relative = point - scan.sensor.position();
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

template <class Predicate>
void LiveLayer::forgetHeldIf(Predicate predicate)
{
  const auto forgotten =
    std::remove_if(held_.begin(), held_.end(), [&](const auto & each) { return predicate(each.seen); });
  held_.erase(forgotten, held_.end());
}

template <class Predicate>
bool LiveLayer::forgetIf(Predicate predicate)
{
  const std::size_t before = cells_.size();
  for (auto cell = cells_.begin(); cell != cells_.end();) {
    cell = predicate(geometry_.centre(geometry_.cell(*cell))) ? cells_.erase(cell) : std::next(cell);
  }
  return cells_.size() != before;
}
}  // namespace move_base
