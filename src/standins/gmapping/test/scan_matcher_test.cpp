#include "scan_matcher.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gmapping
{
namespace
{
/// Puts a wall along x at y (m) into a map, hit by some beams per cell.
void addWall(CellMap & map, double y, int beams)
{
  for (int column = -25; column < 25; ++column) {
    const double x = (column + 0.5) * kMatchingCell;
    for (int i = 0; i < beams; ++i) {
      map.addBeam({x, 0.0}, {x, y}, true);
    }
  }
}

/// Ends of the beams of a lidar in the middle of a road of 2 m.
std::vector<Vec2> bothWalls()
{
  std::vector<Vec2> ends;
  for (int i = -40; i <= 40; ++i) {
    ends.push_back({0.01 * i, -1.0});
    ends.push_back({0.01 * i, 1.0});
  }
  return ends;
}

/// Points a millimetre apart on the faces of posts of 8 cm in a row ahead of a lidar, on both sides of the road.
std::vector<Vec2> posts()
{
  std::vector<Vec2> points;
  for (const double x : {0.5, 1.0, 1.5, 2.0}) {
    for (int i = 0; i < 80; ++i) {
      for (const double y : {-0.8, 0.8}) {
        points.push_back({x + 0.001 * i, y});
        points.push_back({x, y + std::copysign(0.001 * i, y)});
      }
    }
  }
  return points;
}

TEST(ScanMatcher, MapOfCornersHardlyPullsTheScanThatMadeIt)
{
  CellMap map(kMatchingCell);
  for (const Vec2 & point : posts()) {
    map.addBeam({}, point, true);
  }
  const PoseBelief expected{{}, Eigen::Matrix3d::Identity()};
  const PoseBelief matched = ScanMatcher(MatcherOptions()).match(map, posts(), expected);
  // 4 mm if the means around the ends are taken as they are.
  EXPECT_NEAR(matched.mean.x, 0.0, 0.002);
}

TEST(ScanMatcher, WallThatFewBeamsHaveFoundCountsLess)
{
  CellMap map(kMatchingCell);
  addWall(map, 1.004, 40);
  addWall(map, -1.004, 1);
  const PoseBelief expected{{}, Eigen::Matrix3d::Identity()};
  const PoseBelief matched = ScanMatcher(MatcherOptions()).match(map, bothWalls(), expected);
  EXPECT_GT(matched.mean.y, 0.002);
  EXPECT_LT(matched.mean.y, 0.004);
}
}  // namespace
}  // namespace gmapping
