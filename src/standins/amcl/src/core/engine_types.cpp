#include "engine_types.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace amcl
{
namespace
{
using mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CObservation2DRangeScan;

// Probabilities of being free.
constexpr float kFree = 0.99F;
constexpr float kOccupied = 0.01F;
constexpr float kUnknown = 0.5F;
// A map with finer cells is a mistake, and what is kept of the surroundings of each cell does not fit into memory.
constexpr double kLeastResolution = 0.001;  // m
/// Without any chance of ending anywhere, a single beam would rule out every particle.
constexpr double kLeastRandom = 1e-9;

float freedom(std::int8_t cell)
{
  return cell == 0 ? kFree : cell == 100 ? kOccupied : kUnknown;
}

void expectCells(const OccupancyGrid & grid)
{
  const std::size_t count =
    static_cast<std::size_t>(std::max(grid.geometry.width, 0)) * std::max(grid.geometry.height, 0);
  if (count == 0 || grid.cells.size() != count) {
    throw Error(
      "the map has " + std::to_string(grid.geometry.width) + " x " + std::to_string(grid.geometry.height) +
      " cells of " + std::to_string(grid.geometry.resolution) + " m and data for " + std::to_string(grid.cells.size()));
  }
}

void expectGeometry(const GridGeometry & geometry)
{
  // In a message it is a float.
  const bool is_coarse = std::isfinite(geometry.resolution) && geometry.resolution > kLeastResolution - 1e-9;
  requireOption(is_coarse, "resolution of the map", geometry.resolution, "a finite number of at least 0.001");
  requireOption(std::isfinite(geometry.origin.x), "x of the map's origin", geometry.origin.x, "a finite number");
  requireOption(std::isfinite(geometry.origin.y), "y of the map's origin", geometry.origin.y, "a finite number");
  requireOption(std::isfinite(geometry.origin.yaw), "yaw of the map's origin", geometry.origin.yaw, "a finite number");
}

void setLikelihood(COccupancyGridMap2D & map, const LaserOptions & options)
{
  auto & likelihood = map.likelihoodOptions;
  likelihood.likelihoodMethod = options.model == LaserModel::kBeam ? COccupancyGridMap2D::lmRayTracing
                                                                   : COccupancyGridMap2D::lmLikelihoodField_Thrun;
  likelihood.LF_alternateAverageMethod = options.model == LaserModel::kLikelihoodField;
  likelihood.LF_stdHit = static_cast<float>(options.sigma_hit);
  likelihood.LF_zHit = static_cast<float>(options.z_hit);
  likelihood.LF_zRandom = static_cast<float>(std::max(options.z_rand, kLeastRandom));
  likelihood.LF_maxCorrsDistance = static_cast<float>(options.likelihood_max_dist);
  likelihood.LF_decimation = 1;
  likelihood.rayTracing_stdHit = static_cast<float>(options.sigma_hit);
  likelihood.rayTracing_decimation = 1;
}

std::size_t strideOf(const Scan & scan, int max_beams)
{
  // Rounded up, so that there are no more than that.
  const std::size_t gaps = static_cast<std::size_t>(max_beams) - 1;
  return std::max<std::size_t>(1, (scan.ranges.size() - 1 + gaps - 1) / gaps);
}

bool isValid(const Scan & scan, const LaserOptions & options, double range)
{
  const double nearest = options.min_range < 0.0 ? scan.range_min : options.min_range;
  const double farthest = options.max_range < 0.0 ? scan.range_max : std::min(scan.range_max, options.max_range);
  return range >= nearest && range < farthest;  // false for NaN
}
}  // namespace

COccupancyGridMap2D::Ptr toGridMap(const OccupancyGrid & grid, const LaserOptions & options)
{
  expectCells(grid);
  expectGeometry(grid.geometry);
  const auto map = COccupancyGridMap2D::Create();
  const auto resolution = static_cast<float>(grid.geometry.resolution);
  // One more row and column, as MRPT's likelihood fields take the last ones for the outside of the map.
  map->setSize(
    0.0F, static_cast<float>(grid.geometry.width + 1) * resolution, 0.0F,
    static_cast<float>(grid.geometry.height + 1) * resolution, resolution);
  for (int y = 0; y < grid.geometry.height; ++y) {
    for (int x = 0; x < grid.geometry.width; ++x) {
      map->setCell(x, y, freedom(grid.cells[static_cast<std::size_t>(y) * grid.geometry.width + x]));
    }
  }
  setLikelihood(*map, options);
  return map;
}

CObservation2DRangeScan::Ptr toObservation(const Scan & scan, const Pose2 & lidar, const LaserOptions & options)
{
  if (scan.ranges.size() < 2) {
    return nullptr;
  }
  const std::size_t stride = strideOf(scan, options.max_beams);
  const std::size_t count = (scan.ranges.size() - 1) / stride + 1;
  const double width = static_cast<double>((count - 1) * stride) * scan.angle_increment;
  const auto observation = CObservation2DRangeScan::Create();
  observation->rightToLeft = scan.angle_increment > 0.0;
  observation->aperture = static_cast<float>(std::abs(width));
  observation->maxRange = static_cast<float>(scan.range_max);
  // MRPT's scans are symmetric: the sensor looks along the middle beam.
  const Pose2 middle = compose(lidar, {0.0, 0.0, scan.angle_min + 0.5 * width});
  observation->sensorPose = mrpt::poses::CPose3D(mrpt::poses::CPose2D(toTPose2D(middle)));
  observation->resizeScan(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float range = scan.ranges[i * stride];
    const bool valid = isValid(scan, options, range);
    observation->setScanRange(i, valid ? range : 0.0F);
    observation->setScanRangeValidity(i, valid);
  }
  return observation;
}
}  // namespace amcl
