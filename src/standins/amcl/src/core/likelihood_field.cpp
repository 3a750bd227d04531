#include "likelihood_field.h"

#include <workspace_support/distance_transform.h>
#include <workspace_support/maths/exponential.h>
#include <workspace_support/option_checks.h>

#include <algorithm>
#include <string>

namespace amcl
{
namespace
{
constexpr std::int8_t kOccupied = 100;
// A map with finer cells is a mistake, and its distances would not fit into memory.
constexpr double kLeastResolution = 0.001;  // m
/// Without any chance of ending anywhere, a single beam would rule out every particle.
constexpr double kLeastRandom = 1e-9;

void expectCells(const OccupancyGrid & grid)
{
  const GridGeometry & geometry = grid.geometry;
  const bool has_cells = geometry.width > 0 && geometry.height > 0;
  if (!has_cells || grid.cells.size() != geometry.size()) {
    throw Error(
      "the map has " + std::to_string(geometry.width) + " x " + std::to_string(geometry.height) + " cells of " +
      std::to_string(geometry.resolution) + " m and data for " + std::to_string(grid.cells.size()));
  }
}

GridGeometry checked(const OccupancyGrid & grid)
{
  expectCells(grid);
  const GridGeometry & geometry = grid.geometry;
  // In a message it is a float.
  const bool is_coarse = std::isfinite(geometry.resolution) && geometry.resolution > kLeastResolution - 1e-9;
  requireOption(is_coarse, "resolution of the map", geometry.resolution, "a finite number of at least 0.001");
  requireOption(std::isfinite(geometry.origin.x), "x of the map's origin", geometry.origin.x, "a finite number");
  requireOption(std::isfinite(geometry.origin.y), "y of the map's origin", geometry.origin.y, "a finite number");
  requireOption(std::isfinite(geometry.origin.yaw), "yaw of the map's origin", geometry.origin.yaw, "a finite number");
  return geometry;
}
}  // namespace

LikelihoodField::LikelihoodField(const OccupancyGrid & map, const LaserOptions & options)
: options_(options),
  geometry_(checked(map)),
  reach_(static_cast<int>(std::ceil(options.likelihood_max_dist / geometry_.resolution)))
{
  reach_ = std::clamp(reach_, 1, geometry_.width + geometry_.height);
  findDistances(map);
}

void LikelihoodField::findDistances(const OccupancyGrid & map)
{
  std::vector<std::uint8_t> walls(map.cells.size());
  std::transform(
    map.cells.begin(), map.cells.end(), walls.begin(), [](auto cell) { return cell == kOccupied ? 1 : 0; });
  for (const double away : distanceTransform(walls, geometry_.width, geometry_.height)) {
    squares_.push_back(static_cast<std::size_t>(std::lround(std::min(away * away, 1.0 * reach_ * reach_))));
  }
}

void LikelihoodField::setRangeMax(double range_max)
{
  range_max_ = range_max;
  fits_.clear();
  for (int square = 0; square <= reach_ * reach_; ++square) {
    const double away = std::sqrt(static_cast<double>(square)) * geometry_.resolution;
    fits_.push_back(fitOf(std::min(away, options_.likelihood_max_dist)));
  }
}

LikelihoodField::Fit LikelihoodField::fitOf(double away) const
{
  const double deviations = away / options_.sigma_hit;
  const double likelihood =
    options_.z_hit * maths::exp(-0.5 * deviations * deviations) + std::max(options_.z_rand, kLeastRandom) / range_max_;
  return {likelihood * likelihood * likelihood, maths::log(likelihood)};
}

std::size_t LikelihoodField::squaredDistanceAt(const Vec2 & place) const
{
  const double x = place.x / geometry_.resolution;
  const double y = place.y / geometry_.resolution;
  if (!(x >= 0.0 && y >= 0.0 && x < geometry_.width && y < geometry_.height)) {
    return fits_.size() - 1;
  }
  return squares_[geometry_.index({static_cast<int>(x), static_cast<int>(y)})];
}

/// @param measure  of a lidar's place and of a beam's direction in the frame of the grid, and of its range
template <typename Measure>
double LikelihoodField::sum(const Beams & seen, const Pose2 & pose, Measure measure) const
{
  const Pose2 car = compose(inverse(geometry_.origin), pose);
  const Vec2 lidar = transform(car, seen.lidar);
  const maths::SineCosine turn = maths::sineCosine(car.yaw);
  double total = 0.0;
  for (const Beam & beam : seen.beams) {
    const Vec2 & ahead = beam.direction;
    const Vec2 direction{turn.cosine * ahead.x - turn.sine * ahead.y, turn.sine * ahead.x + turn.cosine * ahead.y};
    total += measure(lidar, direction, beam.range);
  }
  return total;
}

double LikelihoodField::logLikelihood(const Beams & seen, const Pose2 & pose) const
{
  switch (options_.model) {
    case LaserModel::kLikelihoodFieldProb:
      return sum(seen, pose, [this](const Vec2 & lidar, const Vec2 & direction, double range) {
        return fits_[squaredDistanceAt(lidar + range * direction)].log;
      });
    case LaserModel::kLikelihoodField:
      return maths::log(1.0 + sum(seen, pose, [this](const Vec2 & lidar, const Vec2 & direction, double range) {
                          return fits_[squaredDistanceAt(lidar + range * direction)].cube;
                        }));
    default:
      return maths::log(1.0 + sum(seen, pose, [this](const Vec2 & lidar, const Vec2 & direction, double range) {
                          return fitOf(range - castInGrid(lidar, direction)).cube;
                        }));
  }
}

/// From each place the beam goes on as far as there is certain to be no wall.
double LikelihoodField::castInGrid(const Vec2 & lidar, const Vec2 & direction) const
{
  const double cell = geometry_.resolution;
  for (double range = 0.0; range < range_max_;) {
    const std::size_t square = squaredDistanceAt(lidar + range * direction);
    if (square == 0) {
      return range;
    }
    range += std::max(0.5, std::sqrt(static_cast<double>(square)) - 1.5) * cell;
  }
  return range_max_;
}
}  // namespace amcl
