#include "move_base/path/path.h"

#include <gtest/gtest.h>

#include "move_base/path/path_tracker.h"

namespace move_base
{
namespace
{
TEST(Geometry, advanceDrivesArcsForwardsAndBackwards)
{
  const Pose2 quarter = advance({0.0, 0.0, 0.0}, M_PI / 2.0, 1.0);
  EXPECT_NEAR(quarter.x, 1.0, 1e-12);
  EXPECT_NEAR(quarter.y, 1.0, 1e-12);
  EXPECT_NEAR(quarter.yaw, M_PI / 2.0, 1e-12);
  const Pose2 back = advance(quarter, -M_PI / 2.0, 1.0);
  EXPECT_NEAR(distance(back, {0.0, 0.0, 0.0}), 0.0, 1e-12);
}

TEST(Geometry, inverseUndoesAPose)
{
  const Pose2 pose{1.0, -2.0, 0.7};
  const Pose2 nothing = compose(pose, inverse(pose));
  EXPECT_NEAR(distance(nothing, {0.0, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(nothing.yaw, 0.0, 1e-12);
}

TEST(ShortestCurves, dubinsNeverReverses)
{
  const ShortestCurves curves(0.8, false);
  const Pose2 from{0.0, 0.0, 0.0};
  const Pose2 to{-1.0, 0.3, 0.4};
  Pose2 pose = from;
  for (const Arc & arc : curves.arcs(from, to)) {
    EXPECT_GT(arc.length, 0.0);
    EXPECT_LE(std::abs(arc.curvature), 1.25 + 1e-9);
    pose = advance(pose, arc.length, arc.curvature);
  }
  EXPECT_NEAR(distance(pose, to), 0.0, 1e-6);
  EXPECT_NEAR(length(curves.arcs(from, to)), curves.length(from, to), 1e-6);
}

TEST(ShortestCurves, reedsSheppBacksUpStraight)
{
  const ShortestCurves curves(0.8, true);
  EXPECT_NEAR(curves.length({0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}), 1.0, 1e-6);
  const std::vector<Arc> arcs = curves.arcs({0.0, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  EXPECT_NEAR(length(arcs), 1.0, 1e-6);
  EXPECT_LT(arcs.front().length, 0.0);
}

TEST(SamplePath, spreadsPointsEvenlyOverEachDirection)
{
  const Path path = samplePath({0.0, 0.0, 0.0}, {{0.35, 0.0}, {0.3, 1.0}, {-0.25, 0.0}}, 0.1);
  ASSERT_EQ(stretches(path).size(), 2U);
  EXPECT_EQ(stretches(path)[0].end, 8U);
  EXPECT_NEAR(path[1].s, 0.65 / 7.0, 1e-12);
  EXPECT_DOUBLE_EQ(path[7].s, path[8].s) << "the car stands where it changes direction";
  EXPECT_TRUE(path[8].reverse);
  EXPECT_NEAR(length(path), 0.9, 1e-12);
}

TEST(SamplePath, ofNoArcsIsThePlaceItself)
{
  EXPECT_EQ(samplePath({1.0, 2.0, 3.0}, {}, 0.1).size(), 1U);
}

TEST(PathTracker, tellsPlaceAndErrorsBesideThePath)
{
  const Path path = samplePath({0.0, 0.0, 0.0}, {{2.0, 0.0}}, 0.1);
  PathTracker tracker(path);
  const PathPosition position = tracker.moveTo(path, {0.73, 0.2, 0.1});
  EXPECT_NEAR(position.s, 0.73, 1e-9);
  EXPECT_NEAR(position.remaining, 1.27, 1e-9);
  EXPECT_NEAR(position.lateral, 0.2, 1e-9);
  EXPECT_NEAR(position.heading_error, 0.1, 1e-9);
}

TEST(PathTracker, keepsToItsLapWhereThePathCrossesItself)
{
  const Path path = samplePath({0.0, 0.0, 0.0}, {{4.0 * M_PI, 1.0}}, 0.1);
  PathTracker tracker(path);
  double last = 0.0;
  for (double s = 0.0; s < 4.0 * M_PI - 0.1; s += 0.1) {
    last = tracker.moveTo(path, advance({0.0, 0.0, 0.0}, s, 1.0)).s;
    EXPECT_NEAR(last, s, 0.01);
  }
  EXPECT_GT(last, 12.0);
}

TEST(PathTracker, goesOnToTheOtherDirectionOnlyWhenTold)
{
  const Path path = samplePath({0.0, 0.0, 0.0}, {{1.0, 0.0}, {-1.0, 0.0}}, 0.1);
  PathTracker tracker(path);
  EXPECT_FALSE(tracker.moveTo(path, {1.0, 0.0, 0.0}).reverse);
  tracker.nextStretch();
  const PathPosition position = tracker.moveTo(path, {1.0, 0.1, 0.0});
  EXPECT_TRUE(position.reverse);
  EXPECT_NEAR(position.lateral, -0.1, 1e-9) << "left of the car is right of its motion";
  tracker.nextStretch();
  EXPECT_TRUE(tracker.moveTo(path, {1.0, 0.1, 0.0}).reverse);
}

TEST(Path, givesTheFirstPointAtAPlaceOrBeyondIt)
{
  const Path path = samplePath({0.0, 0.0, 0.0}, {{1.0, 0.0}}, 0.25);
  EXPECT_EQ(firstBeyond(path, 0.0), 0U);
  EXPECT_EQ(firstBeyond(path, 0.3), 2U);
  EXPECT_EQ(firstBeyond(path, 0.3, 3), 3U);
  EXPECT_EQ(firstBeyond(path, 9.0), path.size() - 1);
}
}  // namespace
}  // namespace move_base
