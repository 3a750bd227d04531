#include "move_base/map/costmap.h"

#include <workspace_support/distance_transform.h>
#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>

namespace move_base
{
namespace
{
// Between the centres of four cells, the weighted mean of their distances from the place, in cells, is at most this.
constexpr double kInterpolationError = 0.7072;

constexpr double kHalfCar = 0.15;  // m, half of what a car needs between two walls

// Which cells are farther than reach, in cells, from all that are marked.
std::vector<std::uint8_t> farFrom(const std::vector<std::uint8_t> & marked, const GridGeometry & geometry, float reach)
{
  const std::vector<float> distances = distanceTransform(marked, geometry.width, geometry.height);
  std::vector<std::uint8_t> far(marked.size());
  std::transform(distances.begin(), distances.end(), far.begin(), [&](float each) { return each > reach ? 1 : 0; });
  return far;
}

// The parts of unknown patches that are no narrower than a car: specks on a road are where nothing was seen.
std::vector<std::uint8_t> widePatches(const std::vector<std::uint8_t> & unknown, const GridGeometry & geometry)
{
  const auto reach = static_cast<float>(kHalfCar / geometry.resolution);
  std::vector<std::uint8_t> known(unknown.size());
  std::transform(unknown.begin(), unknown.end(), known.begin(), [](std::uint8_t each) { return each == 0 ? 1 : 0; });
  const std::vector<std::uint8_t> outside = farFrom(farFrom(known, geometry, reach), geometry, reach);
  std::vector<std::uint8_t> wide(unknown.size());
  std::transform(
    unknown.begin(), unknown.end(), outside.begin(), wide.begin(),
    [](std::uint8_t is_unknown, auto is_outside) { return is_unknown != 0 && is_outside == 0 ? 1 : 0; });
  return wide;
}

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
  std::transform(map.cells.begin(), map.cells.end(), unknown_.begin(), [](int cell) { return cell < 0 ? 1 : 0; });
  std::vector<std::uint8_t> obstacles(geometry_.size(), 0);
  if (!options.allow_unknown) {
    obstacles = widePatches(unknown_, geometry_);
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    obstacles[i] = obstacles[i] != 0 || map.cells[i] >= options.lethal_cost_threshold ? 1 : 0;
  }
  map_distances_ = distanceTransform(obstacles, geometry_.width, geometry_.height);
  for (float & value : map_distances_) {
    value *= static_cast<float>(geometry_.resolution);
  }
  distances_ = map_distances_;

  makeStamp();
}

void Costmap::makeStamp()
{
  // Beyond this, a live obstacle changes neither cost nor collision.
  const double reach = options_.inflation_radius + footprint_.halfWidth();
  stamp_reach_ = static_cast<int>(std::ceil(reach / geometry_.resolution));
  for (int dy = -stamp_reach_; dy <= stamp_reach_; ++dy) {
    for (int dx = -stamp_reach_; dx <= stamp_reach_; ++dx) {
      const double away = maths::hypot(dx, dy) * geometry_.resolution;
      stamp_.push_back(away <= reach ? static_cast<float>(away) : HUGE_VALF);
    }
  }
}

void Costmap::observe(const LaserScan & scan, const std::vector<Vec2> & places)
{
  if (live_.observe(scan, places) || changed_) {
    rebuild();
  }
}

bool Costmap::seesUnknown(const Vec2 & point, double reach) const
{
  return isNearLive(point, reach) && std::any_of(stamped_.begin(), stamped_.end(), [&](const Cell & cell) {
           return distance(geometry_.centre(cell), point) < reach;
         });
}

void Costmap::forgetBeyond(const Vec2 & centre, double radius)
{
  forgetIf([&](const Vec2 & cell) { return distance(cell, centre) > radius; });
  if (changed_) {
    rebuild();
  }
}

template <class Visit>
void Costmap::forStampRows(const Cell & cell, const Visit & visit) const
{
  const int left = std::max(cell.x - stamp_reach_, 0);
  const int right = std::min(cell.x + stamp_reach_, geometry_.width - 1);
  const int count = right - left + 1;
  const int low = std::max(cell.y - stamp_reach_, 0);
  const int high = std::min(cell.y + stamp_reach_, geometry_.height - 1);
  const GridGeometry stamp{2 * stamp_reach_ + 1, 2 * stamp_reach_ + 1, geometry_.resolution, {}};
  for (int y = low; y <= high; ++y) {
    const Cell in_stamp{left - cell.x + stamp_reach_, y - cell.y + stamp_reach_};
    visit(geometry_.index({left, y}), stamp.index(in_stamp), static_cast<std::size_t>(count));
  }
}

void Costmap::rebuild()
{
  for (const Cell & cell : stamped_) {
    forStampRows(cell, [&](std::size_t first, std::size_t, std::size_t count) {
      std::copy_n(map_distances_.data() + first, count, distances_.data() + first);
    });
  }
  stamped_.clear();
  changed_ = false;
  live_low_ = {HUGE_VAL, HUGE_VAL};
  live_high_ = {-HUGE_VAL, -HUGE_VAL};
  for (const std::size_t index : live_.cells()) {
    stamp(geometry_.cell(index));
  }
}

void Costmap::stamp(const Cell & cell)
{
  const Vec2 centre = geometry_.centre(cell);
  const double reach = (stamp_reach_ + 1) * geometry_.resolution;  // distances are read between cells
  live_low_ = {std::min(live_low_.x, centre.x - reach), std::min(live_low_.y, centre.y - reach)};
  live_high_ = {std::max(live_high_.x, centre.x + reach), std::max(live_high_.y, centre.y + reach)};
  stamped_.push_back(cell);
  forStampRows(cell, [&](std::size_t first, std::size_t first_in_stamp, std::size_t count) {
    float * distance = distances_.data() + first;
    const float * stamped = stamp_.data() + first_in_stamp;
    for (std::size_t i = 0; i < count; ++i) {
      distance[i] = std::min(distance[i], stamped[i]);
    }
  });
}

double Costmap::clearance(const Pose2 & base) const
{
  const double c = maths::cos(base.yaw);
  const double s = maths::sin(base.yaw);
  double least = HUGE_VAL;
  for (const Disc & disc : footprint_.discs()) {
    const Vec2 & at = disc.centre;
    const Vec2 centre{base.x + c * at.x - s * at.y, base.y + s * at.x + c * at.y};
    least = std::min(least, obstacleDistance(centre) - disc.radius);
  }
  return least;
}

bool Costmap::isFarFromAll(const Pose2 & base, double margin) const
{
  // Distances from the map's obstacles differ by at most the distance between two places; those read here are
  // interpolated, and there are none beside the map.
  const Vec2 middle = transform(base, footprint_.around().centre);
  const double reach = footprint_.around().radius + margin;
  const double room = reach + std::max(free_clearance_, 0.0) + 2.0 * kInterpolationError * geometry_.resolution;
  if (!(wallDistance(middle) >= room)) {
    return false;
  }
  return !isNearLive(middle, reach) && isInside(middle, reach + geometry_.resolution);
}

// Whether a square around a place, m to each side, reaches into the rectangle around all that is stamped.
bool Costmap::isNearLive(const Vec2 & middle, double reach) const
{
  return middle.x + reach > live_low_.x && middle.x - reach < live_high_.x && middle.y + reach > live_low_.y &&
         middle.y - reach < live_high_.y;
}

// Whether the map reaches so far around a place, m.
bool Costmap::isInside(const Vec2 & middle, double room) const
{
  const Vec2 from_corner = middle - geometry_.origin.position();
  return from_corner.x > room && from_corner.x < geometry_.width * geometry_.resolution - room &&
         from_corner.y > room && from_corner.y < geometry_.height * geometry_.resolution - room;
}

std::int8_t Costmap::shownCost(std::size_t index) const
{
  constexpr std::int8_t kObstacle = 100;
  constexpr std::int8_t kTouching = 99;
  constexpr int kMostCost = 252;  // of a costmap_2d::Costmap2D, that is neither; its 1 to 252 become 1 to 98
  const double away = distances_[index];
  if (away == 0.0) {
    return isUnknown(index) && map_distances_[index] == 0.0 ? std::int8_t{-1} : kObstacle;
  }
  const double beyond = away - footprint_.inscribedRadius();
  if (beyond <= 0.0 || isUnknown(index)) {
    return beyond <= 0.0 ? kTouching : std::int8_t{-1};
  }
  const int cost = static_cast<int>(kMostCost * maths::exp(-options_.cost_scaling_factor * beyond));
  const bool is_free = away > options_.inflation_radius || cost == 0;
  return static_cast<std::int8_t>(is_free ? 0 : 1 + 97 * (cost - 1) / (kMostCost - 1));
}
}  // namespace move_base
