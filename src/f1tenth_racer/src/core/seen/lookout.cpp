#include "seen/lookout.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kMovingMargin = 0.15;  // m around what moves, parts of which the lidar has seen as standing

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
  std::vector<Vec2> hits = costmap.hits(scan);
  tracker_.observe(scan.time, scan.sensor.position(), hits);
  for (const MovingObstacle & obstacle : tracker_.moving()) {
    const Box outline = grown(obstacle.outline, kMovingMargin);
    const auto inside = [&](const Vec2 & hit) { return outline.distanceTo(hit) <= 0.0; };
    hits.erase(std::remove_if(hits.begin(), hits.end(), inside), hits.end());
    costmap.forgetIn(outline);
  }
  for (const StoppedObstacle & obstacle : tracker_.stopped()) {
    const Box outline = obstacle.headed ? obstacle.outline : alongRoad(obstacle.outline, costmap);
    // Nearer to a wall there is no room for a car: it is part of the wall.
    if (costmap.wallDistance(outline.middle.position()) > costmap.footprint().halfWidth()) {
      costmap.hold({outline, obstacle.seen});
    }
  }
  for (const Box & glimpse : tracker_.glimpses()) {
    costmap.forgetIn(grown(glimpse, costmap.geometry().resolution));
  }
  costmap.observe(scan, hits);
}
}  // namespace f1tenth_racer
