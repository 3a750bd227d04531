#include "seen/lookout.h"

#include <gtest/gtest.h>

#include <limits>

#include "roads.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawRoom;
using testing::makeCostmap;
using testing::scanFrom;

constexpr double kScanPeriod = 0.025;  // s
constexpr double kEndless = std::numeric_limits<double>::infinity();

// What the lidar at (2, 2) sees of the top of a low car, straight ahead.
LaserScan scanOfTop(double range, double time)
{
  LaserScan scan = scanFrom({2.0, 2.0, 0.0}, [&](double angle) {
    return std::abs(range * std::tan(angle)) < 0.05 && std::abs(angle) < 1.0 ? range / std::cos(angle) : 9.5;
  });
  scan.time = time;
  return scan;
}

TEST(Lookout, aLowCarThatHasStoppedStandsThereUntilTheLidarSeesThroughWhereItWas)
{
  Costmap costmap = makeCostmap(drawRoom(12.0, 4.0));
  Lookout lookout;
  const Vec2 in_its_tail{4.2, 2.0};
  const double free = costmap.obstacleDistance(in_its_tail);
  double time = 1.0;
  for (; time < 4.0; time += kScanPeriod) {
    lookout.observe(scanOfTop(std::min(1.75 + 1.5 * (time - 1.0), 2.5), time), costmap);
  }
  EXPECT_TRUE(lookout.moving().empty());
  EXPECT_LT(costmap.obstacleDistance(in_its_tail), 0.0);
  lookout.observe(scanOfTop(7.0, time), costmap);
  lookout.observe(scanOfTop(7.0, time + kScanPeriod), costmap);
  EXPECT_DOUBLE_EQ(costmap.obstacleDistance(in_its_tail), free);
}

// The top of a low car that has always stood, seen by a lidar that drives towards it from so far, m/s.
Costmap costmapPastTop(double speed, const Vec2 & top, double half)
{
  Costmap costmap = makeCostmap(drawRoom(12.0, 4.0));
  Lookout lookout;
  for (double time = 1.0; time < 2.0; time += kScanPeriod) {
    const Pose2 lidar{2.0 + speed * (time - 1.0), 2.0, 0.0};
    LaserScan scan = scanFrom(lidar, [&](double angle) {
      const double range = top.x - lidar.x;
      const double y = lidar.y + range * std::tan(angle);
      return std::abs(angle) < 1.0 && std::abs(y - top.y) < half ? range / std::cos(angle) : 9.5;
    });
    scan.time = time;
    lookout.observe(scan, costmap);
  }
  return costmap;
}

TEST(Lookout, whatIsAsSmallAsTheTopOfALowCarMayBeOne)
{
  const Vec2 top{6.0, 2.0};
  const Vec2 in_its_side{6.04, 2.15};
  EXPECT_LT(costmapPastTop(1.0, top, 0.06).obstacleDistance(in_its_side), 0.0);
  EXPECT_GT(costmapPastTop(1.0, top, 0.14).obstacleDistance({6.04, 2.25}), 0.05) << "too large for one";
}

TEST(Lookout, aLowCarThatHasAlwaysStoodIsTakenToStandAlongTheRoad)
{
  const Costmap costmap = costmapPastTop(1.0, {6.0, 2.0}, 0.06);
  EXPECT_LT(costmap.obstacleDistance({6.35, 2.0}), 0.0);
  EXPECT_GT(costmap.obstacleDistance({6.04, 2.35}), 0.05);
}

TEST(Lookout, whoHasNotDrivenTakesNothingForACarThatMayWaitForTheSameStart)
{
  EXPECT_GT(costmapPastTop(0.2, {6.0, 2.0}, 0.06).obstacleDistance({6.04, 2.15}), 0.05);
}

TEST(Lookout, besideAWallThereIsNoRoomForACar)
{
  EXPECT_GT(costmapPastTop(1.0, {6.0, 3.76}, 0.06).obstacleDistance({6.04, 3.55}), 0.05);
}

TEST(Lookout, keepsWhatMovesOutOfTheDistances)
{
  Costmap costmap = makeCostmap(drawRoom(12.0, 4.0));
  Lookout lookout;
  const double free = costmap.obstacleDistance({6.0, 2.0});
  for (int i = 0; i < 20; ++i) {
    const double range = 3.0 + 1.5 * kScanPeriod * i;
    LaserScan scan = scanFrom({2.0, 2.0, 0.0}, [&](double angle) {
      return std::abs(range * std::tan(angle)) < 0.155 && std::abs(angle) < 1.0 ? range / std::cos(angle) : kEndless;
    });
    scan.time = 1.0 + kScanPeriod * i;
    lookout.observe(scan, costmap);
  }
  ASSERT_EQ(lookout.moving().size(), 1U);
  EXPECT_NEAR(lookout.moving()[0].speed, 1.5, 0.1);
  EXPECT_DOUBLE_EQ(costmap.obstacleDistance({6.0, 2.0}), free);
  EXPECT_DOUBLE_EQ(costmap.obstacleDistance({5.0, 2.0}), free);
}
}  // namespace
}  // namespace f1tenth_racer
