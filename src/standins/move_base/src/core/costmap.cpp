#include "move_base/costmap.h"

#include "move_base/distance_transform.h"
#include "option_checks.h"

namespace move_base
{
namespace
{
constexpr double kMovingMargin = 0.15;  // m around what moves, of which the lidar has seen parts as standing

const GridGeometry & checked(const OccupancyGrid & map)
{
  const GridGeometry & geometry = map.geometry;
  if (geometry.width < 2 || geometry.height < 2 || map.cells.size() != geometry.size()) {
    throw Error(
      "map: " + std::to_string(geometry.width) + " x " + std::to_string(geometry.height) + " cells with " +
      std::to_string(map.cells.size()) + " values, must be at least 2 x 2 with one value each");
  }
  requirePositive("map: resolution", geometry.resolution);
  return geometry;
}
}  // namespace

void CostmapOptions::validate() const
{
  requireOption(
    lethal_cost_threshold >= 1 && lethal_cost_threshold <= 100, "lethal_cost_threshold", lethal_cost_threshold,
    "1 to 100");
  requirePositive("inflation_radius", inflation_radius);
  requirePositive("cost_scaling_factor", cost_scaling_factor);
  requireNotNegative("clearance_weight", clearance_weight);
  live.validate();
}

Costmap::Costmap(const OccupancyGrid & map, const CostmapOptions & options, const Footprint & footprint)
: geometry_(checked(map)),
  options_(options),
  footprint_(footprint),
  half_cell_(0.5 * geometry_.resolution),
  free_clearance_(options.inflation_radius - footprint.halfWidth()),
  unknown_(geometry_.size(), 0),
  live_(geometry_, options.live)
{
  options_.validate();
  std::vector<std::uint8_t> obstacles(geometry_.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    unknown_[i] = map.cells[i] < 0 ? 1 : 0;
    obstacles[i] = unknown_[i] != 0 ? !options.allow_unknown : map.cells[i] >= options.lethal_cost_threshold;
  }
  map_distances_ = distanceTransform(obstacles, geometry_.width, geometry_.height);
  for (float & value : map_distances_) {
    value *= static_cast<float>(geometry_.resolution);
  }
  distances_ = map_distances_;

  // Beyond this, a live obstacle changes neither cost nor collision.
  const double reach = options.inflation_radius + footprint.halfWidth();
  const int cells = static_cast<int>(std::ceil(reach / geometry_.resolution));
  for (int dy = -cells; dy <= cells; ++dy) {
    for (int dx = -cells; dx <= cells; ++dx) {
      const double away = std::hypot(dx, dy) * geometry_.resolution;
      if (away <= reach) {
        stamp_.push_back({dx, dy, static_cast<float>(away)});
      }
    }
  }
}

void Costmap::observe(const LaserScan & scan)
{
  std::vector<Vec2> hits = live_.hits(scan, map_distances_);
  tracker_.observe(scan.time, scan.sensor.position(), hits);
  bool changed = false;
  for (const MovingObstacle & obstacle : tracker_.moving()) {
    const Box outline = grown(obstacle.outline, kMovingMargin);
    const auto inside = [&](const Vec2 & hit) { return outline.distanceTo(hit) <= 0.0; };
    hits.erase(std::remove_if(hits.begin(), hits.end(), inside), hits.end());
    changed = live_.forgetIn(outline) || changed;
  }
  for (const Box & glimpse : tracker_.glimpses()) {
    changed = live_.forgetIn(grown(glimpse, geometry_.resolution)) || changed;
  }
  if (live_.observe(scan, hits) || changed) {
    rebuild();
  }
}

void Costmap::forgetBeyond(const Vec2 & centre, double radius)
{
  if (live_.forgetBeyond(centre, radius)) {
    rebuild();
  }
}

void Costmap::rebuild()
{
  for (const std::size_t index : touched_) {
    distances_[index] = map_distances_[index];
  }
  touched_.clear();
  for (const std::size_t index : live_.cells()) {
    stamp(geometry_.cell(index));
  }
  ++revision_;
}

void Costmap::stamp(const Cell & cell)
{
  for (const StampCell & part : stamp_) {
    const Cell at{cell.x + part.dx, cell.y + part.dy};
    if (!geometry_.contains(at)) {
      continue;
    }
    const std::size_t index = geometry_.index(at);
    if (part.distance < distances_[index]) {
      distances_[index] = part.distance;
      touched_.push_back(index);
    }
  }
}

double Costmap::clearance(const Pose2 & base) const
{
  const double c = std::cos(base.yaw);
  const double s = std::sin(base.yaw);
  double least = HUGE_VAL;
  for (const Disc & disc : footprint_.discs()) {
    const Vec2 & at = disc.centre;
    const Vec2 centre{base.x + c * at.x - s * at.y, base.y + s * at.x + c * at.y};
    least = std::min(least, obstacleDistance(centre) - disc.radius);
  }
  return least;
}

std::int8_t Costmap::occupancy(std::size_t index) const
{
  const double clearance = distances_[index] - half_cell_ - footprint_.halfWidth();
  if (distances_[index] == 0.0F) {
    return unknown_[index] != 0 ? -1 : 100;
  }
  if (clearance >= free_clearance_) {
    return 0;
  }
  return static_cast<std::int8_t>(99.0 * std::exp(-options_.cost_scaling_factor * std::max(clearance, 0.0)));
}
}  // namespace move_base
