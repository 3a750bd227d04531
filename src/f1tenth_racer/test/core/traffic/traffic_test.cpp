#include "traffic/traffic.h"

#include <gtest/gtest.h>

#include <functional>

#include "control/path_follower.h"
#include "journey.h"
#include "roads.h"
#include "traffic/keeping_behind.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawOval;
using testing::drawRoom;
using testing::KinematicCar;
using testing::makeCostmap;
using testing::onOval;
using testing::scanFrom;

constexpr double kCycleTime = 0.025;  // s

MovingObstacle carAt(const Pose2 & pose, double speed)
{
  return {{pose, 0.29, 0.155}, speed, 0.0};
}

TEST(Box, tellsTheDistanceOfPoints)
{
  const Box box{{1.0, 2.0, M_PI / 2.0}, 0.5, 0.2};
  EXPECT_NEAR(box.distanceTo({1.0, 3.0}), 0.5, 1e-12);
  EXPECT_NEAR(box.distanceTo({1.5, 2.0}), 0.3, 1e-12);
  EXPECT_NEAR(box.distanceTo({1.5, 2.9}), 0.5, 1e-12);
  EXPECT_NEAR(box.distanceTo({1.0, 2.0}), -0.2, 1e-12);
  EXPECT_NEAR(grown(box, 0.1).distanceTo({1.5, 2.0}), 0.2, 1e-12);
}

TEST(Forecast, followsTheRoad)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast forecast(carAt(onOval(6.0), 2.0), costmap, 0.0);
  for (const double time : {0.5, 1.5, 3.0, 4.0}) {
    EXPECT_LT(distance(forecast.at(time).middle, onOval(6.0 + 2.0 * time)), 0.35) << time;
  }
}

TEST(Forecast, beginsNow)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast forecast(carAt(onOval(1.0), 2.0), costmap, 0.2);
  EXPECT_NEAR(forecast.at(0.0).middle.x, onOval(1.4).x, 1e-9);
}

TEST(Forecast, whoBrakesComesToAStandOnItsWay)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast forecast = Forecast(carAt(onOval(6.0), 3.0), costmap, 0.0).braking(6.0);
  EXPECT_NEAR(forecast.wayToStand(0.0), 0.75, 1e-9);
  EXPECT_NEAR(forecast.wayToStand(0.25), 0.1875, 1e-9);
  EXPECT_EQ(forecast.wayToStand(4.0), 0.0);
  EXPECT_EQ(forecast.lastSpeed(), 0.0);
  EXPECT_NEAR(distance(forecast.at(0.25).middle, onOval(6.0)), 0.5625, 0.05);
  EXPECT_NEAR(distance(forecast.at(4.0).middle, onOval(6.0)), 0.75, 0.05);
}

// A car on the straight of the oval, with a trail on which it was where aside says, m, after a time, s.
MovingObstacle carWithTrail(const std::function<double(double)> & aside)
{
  MovingObstacle car = carAt(onOval(5.0), 2.0);
  car.seen = 2.0;
  for (double time = 0.0; time < 2.05; time += 0.1) {
    const Pose2 place = onOval(1.0 + 2.0 * time);
    const double yaw = std::atan2(aside(time + 0.01) - aside(time), 0.02);
    car.trail.push_back({time, {place.x, place.y + aside(time), yaw}});
  }
  return car;
}

TEST(Forecast, whoKeptToTheRoadIsAsWideAsItIs)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast forecast(carWithTrail([](double) { return 0.0; }), costmap, 2.0);
  for (const double time : {0.0, 1.0, 2.0}) {
    EXPECT_NEAR(forecast.at(time).half_width, 0.155, 0.03) << time;
  }
}

TEST(Forecast, whoWeavesIsWhereverItWeavesTo)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast forecast(carWithTrail([](double time) { return 0.3 * std::sin(M_PI * time); }), costmap, 2.0);
  EXPECT_NEAR(forecast.at(0.0).half_width, 0.155, 1e-9);
  EXPECT_GT(forecast.at(0.5).half_width, 0.3);
  EXPECT_GT(forecast.at(1.0).half_width, 0.5);
  EXPECT_NEAR(forecast.at(3.0).half_width, forecast.at(1.1).half_width, 0.01);
}

TEST(Forecast, whoWeavesStraysAndMayBeOnEitherSideAtOnce)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast weaves(carWithTrail([](double time) { return 0.3 * std::sin(M_PI * time); }), costmap, 2.0);
  const Forecast keeps_on(carWithTrail([](double) { return 0.0; }), costmap, 2.0);
  EXPECT_TRUE(weaves.strays());
  EXPECT_FALSE(keeps_on.strays());
  EXPECT_GT(weaves.anywhere().at(0.0).half_width, weaves.at(2.0).half_width - 1e-9);
  const Pose2 place = weaves.at(0.0).middle;
  EXPECT_NEAR(distance(weaves.anywhere().at(0.0).middle, place), 0.0, 1e-9);
}

// Who weaves at 2 m/s is followed, on whatever side there seems to be room, until the car is beside it.
TEST(PathFollower, keepsBehindWhoWeaves)
{
  const Costmap costmap = makeCostmap(drawOval());
  const auto weaving = [](double time) { return 0.3 * std::sin(M_PI * time) - 0.25; };
  const Forecast forecast(carWithTrail(weaving), costmap, 2.0);
  const Pose2 other = forecast.at(0.0).middle;
  const Footprint & footprint = costmap.footprint();
  PathFollower follower(FollowerOptions{});
  const Pose2 behind = onOval(3.5);
  follower.setPath(samplePath({behind.x, behind.y + 0.35, behind.yaw}, {{6.0, 0.0}}, 0.1), costmap);
  const CarState car{{behind.x, behind.y + 0.35, behind.yaw}, 4.0};
  const Forecast ahead = seenFrom(car.pose, footprint, forecast);
  EXPECT_GT(ahead.at(0.0).half_width, forecast.at(0.0).half_width + 0.3);
  EXPECT_TRUE(follower.hindered(car, costmap, {ahead}));
  const Pose2 beside{other.x - 0.3, other.y + 0.5, 0.0};
  EXPECT_EQ(seenFrom(beside, footprint, forecast).at(0.0).half_width, forecast.at(0.0).half_width);
  EXPECT_TRUE(isBeside(forecast.at(0.0), beside, footprint));
}

// What forecasts are wrong by is left beside another: 0.05 m is too near to pass it, 0.08 m is what ways past keep.
TEST(PathFollower, isHinderedByWhoItWouldPassTooNear)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast slow(carAt(onOval(5.0), 0.5), costmap, 0.0);
  const double touching = slow.at(0.0).half_width + costmap.footprint().halfWidth();
  const auto hindered = [&](double apart) {
    const Pose2 start = onOval(3.5);
    const CarState car{{start.x, start.y + touching + apart, start.yaw}, 2.0};
    PathFollower follower(FollowerOptions{});
    follower.setPath(samplePath(car.pose, {{3.0, 0.0}}, 0.1), costmap);
    return follower.hindered(car, costmap, {slow});
  };
  EXPECT_TRUE(hindered(0.05));
  EXPECT_FALSE(hindered(0.08));
}

TEST(Forecast, whoWeavesIsPassedOnlyBesideAllThatItSweeps)
{
  const Costmap costmap = makeCostmap(drawOval());
  MovingObstacle other = carWithTrail([](double time) { return 0.3 * std::sin(M_PI * time); });
  for (const double speed : {0.6, 1.4}) {
    other.speed = speed;
    const Forecast forecast(other, costmap, 2.0);
    const Forecast ahead = seenFrom(onOval(3.5), costmap.footprint(), forecast);
    EXPECT_GT(ahead.at(0.0).half_width, forecast.at(0.0).half_width + 0.3);
  }
}

TEST(Forecast, whoWentToOneSideGoesThereAgain)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Forecast forecast(
    carWithTrail([](double time) { return 0.4 * std::max(0.0, std::tanh(4.0 * (time - 1.2))); }), costmap, 2.0);
  const Box & later = forecast.at(1.1);
  const double y = later.middle.y - onOval(7.2).y;
  EXPECT_GT(y + later.half_width, 0.45);
  EXPECT_NEAR(y - later.half_width, -0.155, 0.06);
}

// The first touch of a car that drives along x at 2 m/s with another, that does the same.
std::optional<Touch> touchWith(const Pose2 & other, double speed)
{
  const Costmap costmap = makeCostmap(drawRoom(30.0, 8.0));
  const Path path = samplePath({10.0, 4.0, 0.0}, {{15.0, 0.0}}, 0.1);
  const std::vector<double> speeds(path.size(), 2.0);
  const auto drive = driveAlong(path, speeds, {0.0, 0.0, 2.0}, {}, 2.0);
  return firstTouch(drive, costmap.footprint(), Forecast(carAt(other, speed), costmap, 0.0), 0.05);
}

TEST(FirstTouch, tellsWhereTheOtherIs)
{
  const auto ahead = touchWith({12.0, 4.0, 0.0}, 0.5);
  ASSERT_TRUE(ahead);
  EXPECT_TRUE(ahead->ahead);
  EXPECT_FALSE(ahead->behind);
  const auto from_behind = touchWith({9.0, 4.0, 0.0}, 3.5);
  ASSERT_TRUE(from_behind);
  EXPECT_FALSE(from_behind->ahead);
  EXPECT_TRUE(from_behind->behind);
  EXPECT_FALSE(touchWith({10.0, 5.0, 0.0}, 2.0));
}

TEST(FirstTouch, whoTouchesTheCarBesideItsRearAxleIsNotBehind)
{
  // Its front is between the rear axle and the rear end when it comes near from the side.
  const auto beside = touchWith({9.6, 4.65, -0.2}, 2.05);
  ASSERT_TRUE(beside);
  EXPECT_FALSE(beside->ahead);
  EXPECT_FALSE(beside->behind);
}

TEST(FirstTouch, whoIsAheadNowMayBeFallenBackBehind)
{
  // The car has nearly passed it when they come together.
  const auto passed = touchWith({10.88, 4.66, -0.25}, 1.0);
  ASSERT_TRUE(passed);
  EXPECT_TRUE(passed->ahead);
  EXPECT_LT(speedBehind(*passed, 2.0, 5.0).wanted, 1.5);
}

TEST(FirstTouch, whoIsBesideIsAheadIfItsMiddleIs)
{
  // Of two cars of the same length, that come together from the side at the same speed.
  for (const double lead : {-0.1, 0.1}) {
    const auto beside = touchWith({10.0 + 0.165 + lead, 4.6, -0.2}, 2.05);
    ASSERT_TRUE(beside);
    EXPECT_EQ(beside->ahead, lead > 0.0);
    EXPECT_FALSE(beside->behind);
  }
}

TEST(SpeedBehind, isThatOfTheOtherInTheEnd)
{
  // Way and time of a car of 4 m/s to one of 2 m/s.
  const auto behind = [](double gap) { return speedBehind({gap / 2.0, gap * 2.0, 2.0, true}, 4.0, 5.0); };
  EXPECT_GT(behind(6.0).wanted, 4.0);
  EXPECT_LT(behind(1.2).wanted, 3.0);
  EXPECT_LT(behind(0.5).wanted, 2.0);
  double before = 0.0;
  for (double gap = 0.0; gap < 5.0; gap += 0.1) {
    EXPECT_GE(behind(gap).utmost, behind(gap).wanted);
    EXPECT_GE(behind(gap).wanted, before);
    before = behind(gap).wanted;
  }
}

TEST(PathFollower, neverTouchesACarAheadOfIt)
{
  const Costmap costmap = makeCostmap(drawRoom(60.0, 4.0));
  FollowerOptions options;
  options.limits.max_vel_x = 6.0;
  options.limits.acc_lim_x = options.limits.dec_lim_x = 6.0;
  for (const double speed : {0.0, 0.5, 1.5, 3.0}) {
    PathFollower follower(options);
    follower.setPath(samplePath({1.0, 2.0, 0.0}, {{58.0, 0.0}}, 0.1), costmap);
    KinematicCar car({1.0, 2.0, 0.0});
    Pose2 other{7.0, 2.0, 0.0};
    for (double time = 0.0; time < 10.0; time += kCycleTime) {
      const Forecast forecast(carAt(other, speed), costmap, 0.0);
      const FollowStep step = follower.step(car.state(), costmap, kCycleTime, false, {forecast});
      car.drive(step.command, kCycleTime);
      other = advance(other, speed * kCycleTime, 0.0);
      ASSERT_GT(clearance(forecast.at(0.0), costmap.footprint(), car.state().pose), 0.1) << speed << " at " << time;
    }
    EXPECT_NEAR(car.state().speed, speed, 0.3);
    EXPECT_LT(other.x - car.state().pose.x, 3.0) << speed;
    const double left =
      other.x - car.state().pose.x - carAt(other, speed).outline.half_length - costmap.footprint().front();
    EXPECT_GT(left, 0.7) << "from where it can swing out past it";
  }
}

TEST(PathFollower, stopsBehindACarThatBrakesAllAtOnce)
{
  constexpr double kBraking = 6.0;    // m/s^2
  constexpr double kSeenLate = 0.15;  // s
  const Costmap costmap = makeCostmap(drawRoom(60.0, 4.0));
  FollowerOptions options;
  options.limits.max_vel_x = 6.0;
  options.limits.acc_lim_x = options.limits.dec_lim_x = 6.0;
  for (const double way : {6.0, 12.0, 18.0}) {
    PathFollower follower(options);
    follower.setPath(samplePath({1.0, 2.0, 0.0}, {{58.0, 0.0}}, 0.1), costmap);
    KinematicCar car({1.0, 2.0, 0.0});
    Pose2 other{4.0, 2.0, 0.0};
    double speed = 3.0;
    for (double time = 0.0; time < 10.0; time += kCycleTime) {
      const bool brakes = other.x > 4.0 + way;
      const double seen = brakes ? std::min(3.0, speed + kBraking * kSeenLate) : speed;
      const Forecast forecast(carAt(other, speed > 0.0 ? seen : 0.0), costmap, 0.0);
      car.drive(follower.step(car.state(), costmap, kCycleTime, false, {forecast}).command, kCycleTime);
      speed = brakes ? std::max(0.0, speed - kBraking * kCycleTime) : speed;
      other = advance(other, speed * kCycleTime, 0.0);
      ASSERT_GT(clearance(carAt(other, speed).outline, costmap.footprint(), car.state().pose), 0.1) << way;
    }
    EXPECT_NEAR(car.state().speed, 0.0, 0.05);
  }
}

// What a lidar at sensor sees of a car on the road; walls are left out.
LaserScan scanOf(const Box & other, const Pose2 & sensor, double time)
{
  LaserScan scan = scanFrom(sensor, [&](double angle) {
    for (double range = 0.1; range < 8.0; range += 0.02) {
      if (other.distanceTo(sensor.position() + range * Vec2{std::cos(angle), std::sin(angle)}) <= 0.0) {
        return range;
      }
    }
    return std::numeric_limits<double>::infinity();
  });
  scan.time = time;
  return scan;
}

TEST(Navigator, passesASlowerCarWithoutTouchingIt)
{
  testing::JourneyOptions options;
  options.follower.limits.max_vel_x = 5.0;
  options.follower.limits.max_vel_theta = 8.0;
  options.follower.limits.acc_lim_x = options.follower.limits.dec_lim_x = 6.0;
  options.free_goal_vel = options.race_line = true;
  for (const auto & [speed, planner_frequency] : {std::pair{0.8, 0.0}, {1.5, 0.0}, {0.8, 3.0}, {1.5, 3.0}}) {
    options.planner_frequency = planner_frequency;  // plans know nothing of the other
    Costmap costmap = makeCostmap(drawRoom(40.0, 2.4));
    testing::RacingNavigator navigator(options);
    navigator.setGoal({38.0, 1.2, 0.0}, 10.0);
    KinematicCar car({1.0, 1.2, 0.0});
    Box other{{5.0, 1.2, 0.0}, 0.29, 0.155};
    double least = HUGE_VAL;
    for (double time = 10.0; time < 30.0 && navigator.active(); time += kCycleTime) {
      navigator.observe(scanOf(other, car.state().pose, time), costmap);
      const CycleOutput output = navigator.cycle({time, car.state()}, costmap);
      car.drive(output.command.value_or(DriveCommand{}), kCycleTime);
      other.middle = advance(other.middle, speed * kCycleTime, 0.0);
      least = std::min(least, clearance(other, costmap.footprint(), car.state().pose));
    }
    EXPECT_FALSE(navigator.active()) << speed;
    EXPECT_GT(car.state().pose.x, other.middle.x + 5.0) << speed;
    EXPECT_GT(least, 0.05) << speed;
  }
}
}  // namespace
}  // namespace f1tenth_racer
