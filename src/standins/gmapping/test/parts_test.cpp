#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "beams.h"
#include "cell_map.h"
#include "moments.h"
#include "motion.h"

namespace gmapping
{
namespace
{
TEST(HitBeams, LeaveOutWhatHitNothing)
{
  Scan scan;
  scan.range_min = 0.1;
  scan.range_max = 10.0;
  const float infinity = std::numeric_limits<float>::infinity();
  scan.ranges = {1.0F, infinity, -infinity, std::numeric_limits<float>::quiet_NaN(), 0.05F, 10.0F, 2.0F};
  const auto beams = hitBeams(scan, 9.99);
  ASSERT_EQ(beams.size(), 2U);
  EXPECT_DOUBLE_EQ(beams[0].range, 1.0);
  EXPECT_DOUBLE_EQ(beams[1].range, 2.0);
}

TEST(EndsOf, LieWhereTheBeamsPoint)
{
  const auto ends = endsOf({{0.0F, 1.0F, 2.0F}, {-1.0F, 0.0F, 3.0F}});
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_DOUBLE_EQ(ends[0].x, 0.0);
  EXPECT_DOUBLE_EQ(ends[0].y, 2.0);
  EXPECT_DOUBLE_EQ(ends[1].x, -3.0);
}

TEST(RegisterBeams, BeamLongerThanTheUsableRangeIsFreeUpToThere)
{
  CellMap map(0.1);
  registerBeams(map, {{1.0F, 0.0F, 8.0F}}, {0.05, 0.05, 0.0}, 5.0);
  const MapCell * end = map.cell(map.index({5.04, 0.05}));
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->visits, 1U);
  EXPECT_EQ(end->hits, 0U);
  EXPECT_EQ(map.cell(map.index({6.0, 0.05}))->visits, 0U);
}

TEST(CellMap, RemembersWhereBeamsEnded)
{
  CellMap map(0.1);
  map.addBeam({0.05, 0.05}, {1.02, 0.03}, true);
  map.addBeam({0.05, 0.05}, {1.06, 0.05}, true);
  const Cell index = map.index({1.05, 0.05});
  const Vec2 mean = map.meanHit(index, *map.cell(index));
  EXPECT_NEAR(mean.x, 1.04, 1e-6);
  EXPECT_NEAR(mean.y, 0.04, 1e-6);
}

TEST(CellMap, KeepsItsContentsWhenItGrows)
{
  CellMap map(0.1);
  map.addBeam({0.05, 0.05}, {1.02, 0.03}, true);
  map.grow({-30.0, 20.0}, 10.0);
  EXPECT_EQ(map.cell(map.index({1.05, 0.05}))->hits, 1U);
  EXPECT_NE(map.cell(map.index({-39.0, 29.0})), nullptr);
  EXPECT_EQ(map.cell(map.index({100.0, 0.0})), nullptr);
}

TEST(Moments, PointsInARowFormALine)
{
  Moments moments;
  for (const double x : {0.0, 0.05, 0.1}) {
    moments.add({x, 2.0 + x}, 1.0);
  }
  ASSERT_TRUE(moments.normal());
  EXPECT_NEAR(std::abs(moments.normal()->x), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(moments.normal()->x, -moments.normal()->y, 1e-9);
}

TEST(Moments, TwoPointsAndCornersAreNoLine)
{
  Moments two;
  two.add({0.0, 0.0}, 1.0);
  two.add({0.1, 0.0}, 1.0);
  EXPECT_FALSE(two.normal());
  Moments corner;
  for (const Vec2 & point : {Vec2{0.0, 0.0}, Vec2{0.05, 0.0}, Vec2{0.1, 0.0}, Vec2{0.0, 0.05}, Vec2{0.0, 0.1}}) {
    corner.add(point, 1.0);
  }
  EXPECT_FALSE(corner.normal());
}

TEST(ExpectedPose, IsSurestAlongAStraightWay)
{
  MotionNoise noise;
  noise.srr = 0.01;
  const PoseBelief belief = expectedPose({0.0, 0.0, 0.5 * M_PI}, {1.0, 0.0, 0.0}, {1.0, 0.0}, noise);
  EXPECT_NEAR(belief.mean.y, 1.0, 1e-12);
  EXPECT_NEAR(std::sqrt(belief.information.inverse()(1, 1)), 0.0101, 1e-9);
  EXPECT_NEAR(std::sqrt(belief.information.inverse()(0, 0)), 0.0031, 1e-9);
}

}  // namespace
}  // namespace gmapping
