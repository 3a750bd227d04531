#include "scan_tracker.h"

#include <gtest/gtest.h>

#include "rooms.h"

namespace gmapping
{
namespace
{
constexpr double kRange = 10.0;  // m

ScanTracker trackerAtOrigin(double minimum_score = 0.0)
{
  MatcherOptions options;
  options.minimum_score = minimum_score;
  ScanTracker tracker(options, MotionNoise());
  tracker.start(hitBeams(scanInRoom({}), kRange), {}, kRange);
  return tracker;
}

TEST(ScanTracker, LooksAgainAfterSomeWayOrTurn)
{
  ScanTracker tracker = trackerAtOrigin();
  EXPECT_FALSE(tracker.isDue());
  tracker.drive({0.06, 0.0, 0.0});
  EXPECT_FALSE(tracker.isDue());
  tracker.drive({0.06, 0.0, 0.0});
  EXPECT_TRUE(tracker.isDue());
  tracker.look(hitBeams(scanInRoom({0.12, 0.0, 0.0}), kRange));
  EXPECT_FALSE(tracker.isDue());
  tracker.drive({0.0, 0.0, -0.07});
  EXPECT_TRUE(tracker.isDue());
}

TEST(ScanTracker, DoesNotFollowATurnThatOnlyOdometryHasSeen)
{
  ScanTracker tracker = trackerAtOrigin();
  Pose2 truth;
  for (int i = 0; i < 20; ++i) {
    truth.x += 0.1;
    tracker.drive({0.1, 0.0, 0.005});
    tracker.look(hitBeams(scanInRoom(truth), kRange));
  }
  EXPECT_NEAR(tracker.pose().x, truth.x, 0.01);
  EXPECT_NEAR(tracker.pose().y, truth.y, 0.01);
  EXPECT_NEAR(tracker.pose().yaw, 0.0, 0.003);
}

TEST(ScanTracker, ScanThatDoesNotFitTellsNothing)
{
  ScanTracker tracker = trackerAtOrigin(1e6);
  tracker.drive({0.1, 0.0, 0.0});
  tracker.look(hitBeams(scanInRoom({0.11, 0.0, 0.0}), kRange));
  EXPECT_DOUBLE_EQ(tracker.pose().x, 0.1);
  EXPECT_TRUE(tracker.information().isZero());

  ScanTracker fitting = trackerAtOrigin();
  fitting.drive({0.1, 0.0, 0.0});
  fitting.look(hitBeams(scanInRoom({0.11, 0.0, 0.0}), kRange));
  EXPECT_NEAR(fitting.pose().x, 0.11, 0.002);
  EXPECT_FALSE(fitting.information().isZero());
}
}  // namespace
}  // namespace gmapping
