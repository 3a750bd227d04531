#pragma once

#include <cmath>

#include "amcl/geometry.h"

namespace amcl
{
/// From cells on, up to other ones, without these.
struct Pillar
{
  int left;
  int right;
  int bottom;
  int top;
};

/// A room with walls of one cell and a pillar; cells of 0.05 m.
inline OccupancyGrid room(int width, int height, const Pillar & pillar, const Pose2 & origin)
{
  OccupancyGrid grid{{width, height, 0.05, origin}, {}};
  for (int i = 0; i < width * height; ++i) {
    const int x = i % width;
    const int y = i / width;
    const bool wall = x == 0 || x == width - 1 || y == 0 || y == height - 1;
    const bool is_pillar = x >= pillar.left && x < pillar.right && y >= pillar.bottom && y < pillar.top;
    grid.cells.push_back(wall || is_pillar ? 100 : 0);
  }
  return grid;
}

/// One of 8 m by 5 m with a pillar that makes it unlike itself turned around.
inline OccupancyGrid room(const Pose2 & origin = {-3.0, -2.5, 0.0})
{
  return room(160, 100, {120, 130, 60, 80}, origin);
}

/// Whether a place in the map frame is occupied; outside of the map everything is.
inline bool isWall(const OccupancyGrid & grid, const Pose2 & place)
{
  const Pose2 local = compose(inverse(grid.geometry.origin), place);
  const int x = static_cast<int>(std::floor(local.x / grid.geometry.resolution));
  const int y = static_cast<int>(std::floor(local.y / grid.geometry.resolution));
  const bool inside = x >= 0 && x < grid.geometry.width && y >= 0 && y < grid.geometry.height;
  return !inside || grid.cells[y * grid.geometry.width + x] == 100;
}

/// What a lidar at pose sees on the map, 270 degrees, without noise.
inline Scan scanOn(const OccupancyGrid & grid, const Pose2 & pose, int beams = 541)
{
  Scan scan{-0.75 * M_PI, 1.5 * M_PI / (beams - 1), 0.06, 10.0, {}};
  for (int i = 0; i < beams; ++i) {
    const double angle = pose.yaw + scan.angle_min + i * scan.angle_increment;
    double range = 0.0;
    while (range < 10.0 && !isWall(grid, {pose.x + range * std::cos(angle), pose.y + range * std::sin(angle), 0.0})) {
      range += 0.01;
    }
    scan.ranges.push_back(static_cast<float>(range));
  }
  return scan;
}
}  // namespace amcl
