#include "gmapping/grid_slam.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "rooms.h"

namespace gmapping
{
namespace
{
SlamOptions smallMap()
{
  SlamOptions options;
  options.linear_update = 0.2;
  options.angular_update = 0.2;
  options.xmin = options.ymin = -1.0;
  options.xmax = options.ymax = 1.0;
  return options;
}

// Drives 2 m along the room while odometry turns away, 3 degrees per metre. Returns where the last scan that counted was.
Pose2 driveWithDrift(GridSlam & slam)
{
  Pose2 truth;
  Pose2 counted;
  Pose2 odometry;
  slam.process(scanInRoom(truth), odometry, 0.0);
  for (int i = 1; i <= 40; ++i) {
    truth = compose(truth, {0.05, 0.0, 0.0});
    odometry = compose(odometry, {0.05, 0.0, 0.0026});
    if (slam.process(scanInRoom(truth), odometry, 0.025 * i)) {
      counted = truth;
    }
  }
  return counted;
}

// Where the scans that counted were, and where odometry said so.
struct Driven
{
  std::vector<Pose2> truth;
  std::vector<Pose2> odometry;
};

// Three laps of a circle in the room while odometry turns away.
Driven driveInACircle(GridSlam & slam)
{
  Driven counted;
  Pose2 truth{1.0, -1.5, 0.0};
  Pose2 odometry = truth;
  for (int i = 0; i < 140; ++i) {
    if (slam.process(scanInRoom(truth, 361), odometry, 0.025 * i)) {
      counted.truth.push_back(truth);
      counted.odometry.push_back(odometry);
    }
    truth = compose(truth, {0.2, 0.0, 0.2 / 1.5});
    odometry = compose(odometry, {0.2, 0.0, 0.2 / 1.5 + 0.0004});
  }
  return counted;
}

double greatestError(const std::vector<Pose2> & path, const std::vector<Pose2> & truth)
{
  double greatest = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    greatest = std::max(greatest, std::hypot(path[i].x - truth[i].x, path[i].y - truth[i].y));
  }
  return greatest;
}

std::int8_t cellAt(const OccupancyGrid & map, double x, double y)
{
  return map.cells.at(map.geometry.index(map.geometry.cellAt({x, y})));
}

std::string complaint(GridSlam & slam, const Scan & scan, const Pose2 & odometry)
{
  try {
    slam.process(scan, odometry, 0.0);
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}

TEST(GridSlam, FirstScanIsPutWhereOdometrySays)
{
  const auto slam = GridSlam::make(smallMap());
  EXPECT_TRUE(slam->process(scanInRoom({}), {1.0, 2.0, 0.5}, 0.0));
  EXPECT_DOUBLE_EQ(slam->pose().x, 1.0);
  EXPECT_DOUBLE_EQ(slam->pose().y, 2.0);
  EXPECT_DOUBLE_EQ(slam->pose().yaw, 0.5);
}

TEST(GridSlam, MapHasFreeOccupiedAndUnknownCells)
{
  const auto slam = GridSlam::make(smallMap());
  slam->process(scanInRoom({}), {}, 0.0);
  const OccupancyGrid map = slam->map();
  EXPECT_EQ(cellAt(map, 1.0, 0.1), 0);
  EXPECT_EQ(cellAt(map, 5.02, 0.01), 100);
  EXPECT_EQ(cellAt(map, 6.0, 0.0), -1);
}

TEST(GridSlam, OnlyScansFarEnoughFromTheLastCount)
{
  const auto slam = GridSlam::make(smallMap());
  EXPECT_TRUE(slam->process(scanInRoom({}), {}, 0.0));
  EXPECT_FALSE(slam->process(scanInRoom({}), {0.19, 0.0, 0.0}, 0.1));
  EXPECT_TRUE(slam->process(scanInRoom({}), {0.21, 0.0, 0.0}, 0.2));
  EXPECT_FALSE(slam->process(scanInRoom({}), {0.21, 0.0, 0.19}, 0.3));
  EXPECT_TRUE(slam->process(scanInRoom({}), {0.21, 0.0, 0.21}, 0.4));
  EXPECT_FALSE(slam->process(scanInRoom({}), {0.21, 0.0, 0.21}, 1000.0));
}

TEST(GridSlam, StandingScansCountAfterTheTemporalUpdate)
{
  SlamOptions options = smallMap();
  options.temporal_update = 1.0;
  const auto slam = GridSlam::make(options);
  slam->process(scanInRoom({}), {}, 0.0);
  EXPECT_FALSE(slam->process(scanInRoom({}), {}, 0.9));
  EXPECT_TRUE(slam->process(scanInRoom({}), {}, 1.1));
}

TEST(GridSlam, CorrectsOdometryThatTurnsAway)
{
  const auto slam = GridSlam::make(smallMap());
  const Pose2 truth = driveWithDrift(*slam);
  EXPECT_NEAR(slam->pose().x, truth.x, 0.03);
  EXPECT_NEAR(slam->pose().y, truth.y, 0.03);
  EXPECT_NEAR(slam->pose().yaw, truth.yaw, 0.01);
}

TEST(GridSlam, SameScansGiveTheSameMap)
{
  const auto first = GridSlam::make(smallMap());
  const auto second = GridSlam::make(smallMap());
  driveWithDrift(*first);
  driveWithDrift(*second);
  EXPECT_EQ(first->map().cells, second->map().cells);
  EXPECT_EQ(first->pose().yaw, second->pose().yaw);
}

TEST(GridSlam, MapHasAtLeastTheExtentAskedForAndGrows)
{
  const auto slam = GridSlam::make(smallMap());
  slam->process(scanInRoom({}), {}, 0.0);
  const OccupancyGrid small = slam->map();
  EXPECT_GT(small.geometry.width * small.geometry.resolution, 8.0);

  SlamOptions large = smallMap();
  large.xmin = -40.0;
  const auto wide = GridSlam::make(large);
  wide->process(scanInRoom({}), {}, 0.0);
  EXPECT_NEAR(wide->map().geometry.origin.x, -40.0, 0.026);
  EXPECT_EQ(cellAt(wide->map(), 5.02, 0.01), 100);
}

TEST(GridSlam, ScanThatDoesNotSayWhereItsBeamsAreIsRefused)
{
  const auto slam = GridSlam::make(smallMap());
  Scan scan = scanInRoom({});
  scan.range_max = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint(*slam, scan, {}), "range_max: found inf, must be a finite number above 0");
  scan = scanInRoom({});
  scan.angle_increment = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint(*slam, scan, {}), "angle_increment: found nan, must be a finite number other than 0");
  EXPECT_TRUE(slam->process(scanInRoom({}), {}, 0.0));
}

TEST(GridSlam, ScanThatTheMapCannotGrowForIsRefusedAndThoseAfterItAreNot)
{
  const auto slam = GridSlam::make(smallMap());
  Scan far = scanInRoom({});
  far.range_max = 1e6;
  EXPECT_EQ(complaint(*slam, far, {}), "map: found 2e+06 m x 2e+06 m of cells of 0.02 m, must be at most 4e+08 cells");
  EXPECT_TRUE(slam->process(scanInRoom({}), {}, 0.0));
  EXPECT_NE(complaint(*slam, scanInRoom({}), {1e6, 1e6, 0.0}), "");
  EXPECT_TRUE(slam->process(scanInRoom({0.3, 0.0, 0.0}), {0.3, 0.0, 0.0}, 0.2));
  EXPECT_NEAR(slam->pose().x, 0.3, 0.05);
  EXPECT_LT(slam->map().geometry.width, 1000);
}

TEST(GridSlam, ScanThatMatchesBadlyLeavesThePoseToOdometry)
{
  SlamOptions options = smallMap();
  options.matcher.minimum_score = 1000.0;
  const auto slam = GridSlam::make(options);
  slam->process(scanInRoom({}), {}, 0.0);
  slam->process(scanInRoom({0.3, 0.1, 0.0}), {0.3, 0.0, 0.0}, 0.1);
  EXPECT_DOUBLE_EQ(slam->pose().x, 0.3);
  EXPECT_DOUBLE_EQ(slam->pose().y, 0.0);
}

TEST(GridSlam, ClosedLoopTakesTheDriftOfOdometryBackFromAllPoses)
{
  SlamOptions options = smallMap();
  options.matcher.minimum_score = 1e6;  // only odometry and loops count
  const auto slam = GridSlam::make(options);
  const Driven driven = driveInACircle(*slam);
  EXPECT_GT(greatestError(driven.odometry, driven.truth), 0.08);
  ASSERT_EQ(slam->path().size(), driven.truth.size());
  EXPECT_LT(greatestError(slam->path(), driven.truth), 0.05);
  EXPECT_EQ(cellAt(slam->map(), 5.02, 0.01), 100);
}
}  // namespace
}  // namespace gmapping
