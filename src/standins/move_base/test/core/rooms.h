#pragma once

#include <functional>
#include <utility>

#include "move_base/map/costmap.h"

/// Maps for tests, 0.05 m per cell, the lower left corner at the origin.
namespace move_base::testing
{
constexpr double kResolution = 0.05;

/// A map of the given size in m; occupied(x, y) says where obstacles are.
inline OccupancyGrid drawMap(double width, double height, const std::function<bool(const Vec2 &)> & occupied)
{
  OccupancyGrid grid;
  grid.geometry.width = static_cast<int>(std::lround(width / kResolution));
  grid.geometry.height = static_cast<int>(std::lround(height / kResolution));
  grid.geometry.resolution = kResolution;
  for (std::size_t i = 0; i < grid.geometry.size(); ++i) {
    grid.cells.push_back(occupied(grid.geometry.centre(grid.geometry.cell(i))) ? 100 : 0);
  }
  return grid;
}

inline bool inRectangle(const Vec2 & point, const Vec2 & low, const Vec2 & high)
{
  return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y;
}

/// An empty room in walls of 0.1 m.
inline OccupancyGrid drawRoom(double width, double height)
{
  return drawMap(width, height, [=](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {width - 0.1, height - 0.1});
  });
}

/// A hairpin: two lanes of 1.4 m, one above the other, joined at the right; closed at the left.
inline OccupancyGrid drawHairpin()
{
  return drawMap(8.0, 3.6, [](const Vec2 & p) {
    const bool inside = inRectangle(p, {0.1, 0.1}, {7.9, 3.5});
    const bool divider = inRectangle(p, {0.0, 1.5}, {6.3, 2.1});
    return !inside || divider;
  });
}

/// A stadium-shaped track: straights of 8 m along x at y = 2 and y = 8, joined by half circles; 1.6 m wide.
inline OccupancyGrid drawOval()
{
  return drawMap(18.0, 10.0, [](const Vec2 & p) {
    const Vec2 core{std::clamp(p.x, 5.0, 13.0), 5.0};
    return std::abs(distance(p, core) - 3.0) > 0.8;
  });
}

/// The middle of the oval at the distance s in m from (5, 2), counter-clockwise.
inline Pose2 onOval(double s)
{
  const double turn = 3.0 * M_PI;
  s = std::fmod(s, 16.0 + 2.0 * turn);
  if (s < 8.0) {
    return {5.0 + s, 2.0, 0.0};
  }
  if (s < 8.0 + turn) {
    return advance({13.0, 2.0, 0.0}, s - 8.0, 1.0 / 3.0);
  }
  if (s < 16.0 + turn) {
    return {13.0 - (s - 8.0 - turn), 8.0, M_PI};
  }
  return advance({5.0, 8.0, M_PI}, s - 16.0 - turn, 1.0 / 3.0);
}

inline Costmap makeCostmap(const OccupancyGrid & map, CostmapOptions options = {})
{
  options.inflation_radius = std::max(options.inflation_radius, 0.8);
  options.cost_scaling_factor = 4.0;
  return Costmap(map, options, Footprint(defaultFootprint()));
}

/// What a lidar at sensor sees: a beam per degree all around, of ranges that range(angle in the map) gives.
inline LaserScan scanFrom(const Pose2 & sensor, const std::function<double(double)> & range)
{
  LaserScan scan;
  scan.sensor = sensor;
  scan.angle_min = -M_PI;
  scan.angle_increment = M_PI / 180.0;
  scan.range_min = 0.05;
  scan.range_max = 10.0;
  for (int i = 0; i < 360; ++i) {
    scan.ranges.push_back(static_cast<float>(range(sensor.yaw + scan.angle_min + i * scan.angle_increment)));
  }
  return scan;
}
}  // namespace move_base::testing
