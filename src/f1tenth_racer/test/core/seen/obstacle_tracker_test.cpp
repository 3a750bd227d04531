#include "seen/obstacle_tracker.h"

#include <gtest/gtest.h>

namespace f1tenth_racer
{
namespace
{
constexpr double kScan = 0.025;  // s

// The hits on a rectangle as seen from viewer: the sides that face it, in turn, a hit every 4 cm.
std::vector<Vec2> sidesOf(const Box & box, const Vec2 & viewer)
{
  const Vec2 seen_from = transform(inverse(box.middle), viewer);
  std::vector<Vec2> hits;
  const auto side = [&](const Vec2 & from, const Vec2 & to) {
    const int count = static_cast<int>(distance(from, to) / 0.04) + 1;
    for (int i = 0; i <= count; ++i) {
      hits.push_back(transform(box.middle, from + (static_cast<double>(i) / count) * (to - from)));
    }
  };
  const double l = box.half_length;
  const double w = box.half_width;
  if (std::abs(seen_from.x) > l) {
    const double x = std::copysign(l, seen_from.x);
    const double nearer = std::copysign(w, seen_from.y);
    side({x, -nearer}, {x, nearer});
  }
  if (std::abs(seen_from.y) > w) {
    const double y = std::copysign(w, seen_from.y);
    const double nearer = std::copysign(l, seen_from.x);
    side({nearer, y}, {-nearer, y});
  }
  return hits;
}

// Shows a box that drives on, to a viewer that may drive, too.
std::vector<MovingObstacle> watch(
  Box box, double speed, double duration, Vec2 viewer = {0.0, 0.0}, const Vec2 & viewer_speed = {0.0, 0.0})
{
  ObstacleTracker tracker;
  for (double time = 1.0; time < 1.0 + duration; time += kScan) {
    tracker.observe(time, viewer, sidesOf(box, viewer));
    box.middle = advance(box.middle, speed * kScan, 0.0);
    viewer = viewer + kScan * viewer_speed;
  }
  return tracker.moving();
}

const Box kCar{{4.0, 0.5, 0.3}, 0.29, 0.155};

TEST(ObstacleTracker, tellsHowFastACarDrivesAndWhere)
{
  for (const double speed : {0.6, 1.5, 3.0}) {
    const auto moving = watch(kCar, speed, 0.5);
    ASSERT_EQ(moving.size(), 1U) << speed;
    EXPECT_NEAR(moving[0].speed, speed, 0.05);
    EXPECT_NEAR(moving[0].outline.middle.yaw, 0.3, 0.1);
    EXPECT_GE(moving[0].outline.half_length, 0.289);
    EXPECT_GE(moving[0].outline.half_width, 0.154);
    EXPECT_LT(distance(moving[0].outline.middle, advance(kCar.middle, speed * 0.475, 0.0)), 0.1);
  }
}

TEST(ObstacleTracker, aBoxThatIsPassedStands)
{
  const Box box{{3.0, 0.8, 0.2}, 0.3, 0.2};
  for (double duration = 0.1; duration < 1.2; duration += 0.1) {
    EXPECT_TRUE(watch(box, 0.0, duration, {0.0, 0.0}, {6.0, 0.0}).empty()) << duration;
  }
}

TEST(ObstacleTracker, takesTheTopOfALowCarForItsMiddle)
{
  const auto moving = watch({{4.0, 0.0, 0.0}, 0.04, 0.04}, 1.0, 0.5);
  ASSERT_EQ(moving.size(), 1U);
  EXPECT_NEAR(moving[0].outline.half_length, 0.4, 1e-9);
  EXPECT_GT(moving[0].outline.half_width, 0.155);
}

TEST(ObstacleTracker, needsATenthOfASecondToTell)
{
  EXPECT_TRUE(watch(kCar, 1.5, 0.08).empty());
  EXPECT_FALSE(watch(kCar, 1.5, 0.15).empty());
}

TEST(ObstacleTracker, aCarThatStopsIsNoMovingObstacleAfterASecond)
{
  ObstacleTracker tracker;
  Box box = kCar;
  for (double time = 1.0; time < 3.5; time += kScan) {
    tracker.observe(time, {}, sidesOf(box, {}));
    if (time < 1.5) {
      box.middle = advance(box.middle, 1.5 * kScan, 0.0);
    }
    if (time > 1.6 && time < 2.3) {
      ASSERT_EQ(tracker.moving().size(), 1U) << time;
    }
  }
  EXPECT_TRUE(tracker.moving().empty());
  ASSERT_EQ(tracker.stopped().size(), 1U);
  EXPECT_LE(tracker.stopped()[0].outline.distanceTo(box.middle.position()), -0.15);
  EXPECT_LE(box.distanceTo(tracker.stopped()[0].seen), 0.0);
}

TEST(ObstacleTracker, whoSlowsDownForLongAndStopsHasDriven)
{
  ObstacleTracker tracker;
  Box box = kCar;
  double speed = 0.8;
  for (double time = 1.0; time < 6.0; time += kScan) {
    tracker.observe(time, {}, sidesOf(box, {}));
    box.middle = advance(box.middle, speed * kScan, 0.0);
    speed = time < 3.0 ? speed : std::max(0.0, speed - 1.0 * kScan);
  }
  EXPECT_TRUE(tracker.moving().empty());
  EXPECT_EQ(tracker.stopped().size(), 1U);
}

TEST(ObstacleTracker, tellsWhereSomethingHasBeen)
{
  const auto moving = watch(kCar, 1.5, 3.0);
  ASSERT_EQ(moving.size(), 1U);
  ASSERT_GT(moving[0].trail.size(), 10U);
  const Sight & first = moving[0].trail.front();
  const Sight & last = moving[0].trail.back();
  EXPECT_NEAR(distance(first.pose, last.pose), 1.5 * (last.time - first.time), 0.05);
  EXPECT_NEAR(last.time - first.time, 2.0, 0.15);
  EXPECT_NEAR(distance(last.pose, moving[0].outline.middle), 0.0, 0.2);
  EXPECT_NEAR(first.pose.yaw, 0.3, 0.1);
}

TEST(ObstacleTracker, namesWhatItSawForTooShortATime)
{
  ObstacleTracker tracker;
  tracker.observe(1.0, {}, sidesOf(kCar, {}));
  tracker.observe(1.1, {}, {});
  EXPECT_TRUE(tracker.glimpses().empty());
  tracker.observe(1.3, {}, {});
  ASSERT_EQ(tracker.glimpses().size(), 1U);
  EXPECT_LE(tracker.glimpses()[0].distanceTo(sidesOf(kCar, {}).front()), 1e-9);
}

TEST(ObstacleTracker, forgetsWhenTimeJumpsBack)
{
  ObstacleTracker tracker;
  Box box = kCar;
  for (double time = 5.0; time < 5.5; time += kScan) {
    tracker.observe(time, {}, sidesOf(box, {}));
    box.middle = advance(box.middle, 1.5 * kScan, 0.0);
  }
  ASSERT_FALSE(tracker.moving().empty());
  tracker.observe(1.0, {}, sidesOf(box, {}));
  EXPECT_TRUE(tracker.moving().empty());
}
}  // namespace
}  // namespace f1tenth_racer
