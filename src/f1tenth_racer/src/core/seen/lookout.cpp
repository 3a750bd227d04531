#include "seen/lookout.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kMovingMargin = 0.15;  // m around what moves, parts of which the lidar has seen as standing
constexpr double kSameStanding = 0.3;   // m

template <class Items, class Predicate>
void removeIf(Items & items, const Predicate & predicate)
{
  items.erase(std::remove_if(items.begin(), items.end(), predicate), items.end());
}

// A car stands along its road, which is where there is room to both ends of it; where no way is much freer than the
// others, it is as wide as a car, whatever the side.
Box alongRoad(const Box & outline, const Costmap & costmap)
{
  constexpr int kHeadings = 18;
  constexpr double kClearlyFreer = 0.15;  // m
  const double here = costmap.wallDistance(outline.middle.position());
  Box best = outline;
  double most = -HUGE_VAL;
  double least = HUGE_VAL;
  for (int i = 0; i < kHeadings; ++i) {
    Box turned = outline;
    turned.middle.yaw = normalizeAngle(i * M_PI / kHeadings);
    const Pose2 back = compose(turned.middle, {0.0, 0.0, M_PI});
    const double room = std::min({here, roomAlong(costmap, turned.middle, 0.0), roomAlong(costmap, back, 0.0)});
    best = room > most ? turned : best;
    most = std::max(most, room);
    least = std::min(least, room);
  }
  if (most < least + kClearlyFreer) {
    best.half_length = best.half_width;
  }
  return best;
}
}  // namespace

double roomAlong(const Costmap & costmap, const Pose2 & from, double curvature)
{
  constexpr double kReach = 1.2;  // m
  constexpr double kStep = 0.15;  // m
  double room = HUGE_VAL;
  for (double s = kStep; s <= kReach; s += kStep) {
    room = std::min(room, costmap.wallDistance(advance(from, s, curvature).position()));
  }
  return room;
}

void Lookout::observe(const LaserScan & scan, Costmap & costmap)
{
  removeIf(standing_, [&](const Standing & each) { return !costmap.isMarked(each.seen); });
  std::vector<Vec2> hits = costmap.hits(scan);
  tracker_.observe(scan.time, scan.sensor.position(), hits);
  for (const MovingObstacle & obstacle : tracker_.moving()) {
    const Box outline = grown(obstacle.outline, kMovingMargin);
    removeIf(hits, [&](const Vec2 & hit) { return outline.distanceTo(hit) <= 0.0; });
    forgetIn(outline, costmap);
  }
  for (const StoppedObstacle & obstacle : tracker_.stopped()) {
    const Box outline = obstacle.headed ? obstacle.outline : alongRoad(obstacle.outline, costmap);
    // Nearer to a wall there is no room for a car: it is part of the wall.
    if (costmap.wallDistance(outline.middle.position()) > costmap.footprint().halfWidth()) {
      hold(outline, obstacle.seen, costmap);
    }
  }
  for (const Box & glimpse : tracker_.glimpses()) {
    forgetIn(grown(glimpse, costmap.geometry().resolution), costmap);
  }
  removeIf(standing_, [&](const Standing & each) { return costmap.seesThrough(scan, each.seen); });
  for (const Standing & each : standing_) {
    hits.insert(hits.end(), each.places.begin(), each.places.end());
  }
  costmap.observe(scan, hits);
}

void Lookout::hold(const Box & outline, const Vec2 & seen, const Costmap & costmap)
{
  const auto same = [&](const Standing & known) { return distance(known.seen, seen) < kSameStanding; };
  if (std::any_of(standing_.begin(), standing_.end(), same)) {
    return;
  }
  const GridGeometry & geometry = costmap.geometry();
  const Vec2 reach = (outline.half_length + outline.half_width) * Vec2{1.0, 1.0};
  const Cell low = geometry.cellAt(outline.middle.position() - reach);
  const Cell high = geometry.cellAt(outline.middle.position() + reach);
  standing_.push_back({{}, seen});
  for (Cell cell{0, low.y}; cell.y <= high.y; ++cell.y) {
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      if (geometry.contains(cell) && outline.distanceTo(geometry.centre(cell)) <= 0.0) {
        standing_.back().places.push_back(geometry.centre(cell));
      }
    }
  }
}

void Lookout::forgetIn(const Box & outline, Costmap & costmap)
{
  const auto inside = [&](const Vec2 & place) { return outline.distanceTo(place) <= 0.0; };
  removeIf(standing_, [&](const Standing & each) { return inside(each.seen); });
  for (Standing & each : standing_) {
    removeIf(each.places, inside);
  }
  costmap.forgetIf(inside);
}
}  // namespace f1tenth_racer
