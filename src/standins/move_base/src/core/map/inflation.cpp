#include "move_base/map/inflation.h"

#include <workspace_support/maths/exponential.h>

#include <algorithm>
#include <cmath>

#include "map/distance_transform.h"

namespace move_base
{
namespace
{
constexpr std::int8_t kObstacle = 100;
constexpr std::int8_t kTouching = 99;
constexpr int kMostCost = 252;  // of a costmap_2d::Costmap2D, that is neither touching nor an obstacle

// costmap_2d's scale of 1 to 252 becomes 1 to 98.
std::int8_t shown(int cost)
{
  return static_cast<std::int8_t>(cost == 0 ? 0 : 1 + 97 * (cost - 1) / (kMostCost - 1));
}

// @param cells_away  distance between the middles of two cells
std::int8_t costAt(double cells_away, double resolution, const Inflation & inflation)
{
  const double away = cells_away * resolution;
  if (away <= inflation.inscribed_radius) {
    return kTouching;
  }
  if (cells_away > std::ceil(inflation.radius / resolution)) {
    return 0;
  }
  const double factor = maths::exp(-inflation.cost_scaling_factor * (away - inflation.inscribed_radius));
  return shown(static_cast<int>(kMostCost * factor));
}
}  // namespace

std::vector<std::int8_t> inflated(
  const std::vector<std::int8_t> & cells, const GridGeometry & geometry, const Inflation & inflation)
{
  std::vector<std::uint8_t> obstacles(cells.size());
  std::transform(cells.begin(), cells.end(), obstacles.begin(), [](std::int8_t cell) {
    return static_cast<std::uint8_t>(cell == kObstacle);
  });
  const std::vector<float> distances = distanceTransform(obstacles, geometry.width, geometry.height);
  std::vector<std::int8_t> costs(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] == kObstacle) {
      costs[i] = kObstacle;
      continue;
    }
    const std::int8_t cost = costAt(distances[i], geometry.resolution, inflation);
    costs[i] = cells[i] < 0 && cost < kTouching ? std::int8_t{-1} : cost;
  }
  return costs;
}

void addObstacles(OccupancyGrid & costs, const std::vector<Cell> & obstacles, const Inflation & inflation)
{
  if (obstacles.empty()) {
    return;
  }
  const GridGeometry & geometry = costs.geometry;
  const int reach =
    static_cast<int>(std::ceil(std::max(inflation.radius, inflation.inscribed_radius) / geometry.resolution));
  const GridGeometry square{2 * reach + 1, 2 * reach + 1, geometry.resolution, {}};
  std::vector<std::int8_t> around(square.size(), 0);
  around[square.index({reach, reach})] = kObstacle;
  around = inflated(around, square, inflation);
  for (const Cell & obstacle : obstacles) {
    const Cell low{std::max(obstacle.x - reach, 0), std::max(obstacle.y - reach, 0)};
    const Cell high{
      std::min(obstacle.x + reach, geometry.width - 1), std::min(obstacle.y + reach, geometry.height - 1)};
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const std::int8_t added = around[square.index({x - obstacle.x + reach, y - obstacle.y + reach})];
        std::int8_t & cost = costs.cells[geometry.index({x, y})];
        if (added > cost && (cost >= 0 || added >= kTouching)) {
          cost = added;
        }
      }
    }
  }
}
}  // namespace move_base
