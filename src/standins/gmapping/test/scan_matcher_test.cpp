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

/// What a lidar in the middle of a road of 2 m sees of its walls.
std::vector<Beam> bothWalls()
{
  std::vector<Beam> beams;
  for (int i = -40; i <= 40; ++i) {
    for (const double y : {-1.0, 1.0}) {
      const double x = 0.01 * i;
      const double range = std::hypot(x, y);
      beams.push_back({static_cast<float>(x / range), static_cast<float>(y / range), static_cast<float>(range)});
    }
  }
  return beams;
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
