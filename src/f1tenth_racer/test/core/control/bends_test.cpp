#include <gtest/gtest.h>

#include "control/path_follower.h"
#include "kinematic_car.h"
#include "racing_follower.h"
#include "roads.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawOval;
using testing::drawRoom;
using testing::KinematicCar;
using testing::kStepTime;
using testing::makeCostmap;
using testing::racingFollower;
using testing::scanFrom;

// How much slower than it drives a car is told to be that meets an obstacle, m/s, after 3 m of a way so bent, 1/m, while
// it turns so fast, rad/s.
double brakingInBend(double curvature, double yaw_rate = 0.0)
{
  Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  PathFollower follower(racingFollower());
  const Pose2 start{4.0, 4.0, 0.0};
  follower.setPath(samplePath(start, {{12.0, curvature}}, 0.1), costmap);
  KinematicCar car(start);
  while (distance(car.state().pose, start) < 3.0) {
    car.drive(follower.step(car.state(), costmap, kStepTime).command, kStepTime);
  }
  const Pose2 seen_from = car.state().pose;
  costmap.observe(scanFrom(
    seen_from, [&](double angle) { return std::abs(normalizeAngle(angle - seen_from.yaw)) < 0.8 ? 0.6 : 20.0; }));
  const CarState turning{seen_from, car.state().speed, yaw_rate};
  return turning.speed - follower.step(turning, costmap, kStepTime).command.speed;
}

TEST(PathFollower, brakesWithWhatTheTyresHaveLeftInABend)
{
  const double lead = racingFollower().latency + Handling::kSpeedLag;
  EXPECT_GT(brakingInBend(0.0), 2.0) << "as hard as it can";
  EXPECT_GT(brakingInBend(0.4), 0.2 * 3.0 * lead);
  EXPECT_LT(brakingInBend(0.4), 0.6 * 3.0 * lead);
}

TEST(PathFollower, isInABendForAsLongAsItTurns)
{
  const double lead = racingFollower().latency + Handling::kSpeedLag;
  for (const double yaw_rate : {0.6, -0.6}) {
    EXPECT_GT(brakingInBend(0.0, yaw_rate), 0.4 * 3.0 * lead);
    EXPECT_LT(brakingInBend(0.0, yaw_rate), 0.9 * 3.0 * lead);
  }
  EXPECT_GT(brakingInBend(0.0, 0.1), 2.0) << "as hard as it can";
}

// The speed commanded in a bend to a car that is so far outside of its path, m, less that of the step before, m/s.
double changeOutsideOfBend(double outside)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  PathFollower follower(racingFollower());
  follower.setPath(samplePath({6.0, 4.0, 0.0}, {{14.0, 0.3}}, 0.1), costmap);
  KinematicCar car({6.0, 4.0, 0.0});
  while (follower.placeOf(car.state()) < 6.0) {
    car.drive(follower.step(car.state(), costmap, kStepTime).command, kStepTime);
  }
  CarState beside = car.state();
  beside.pose.x += outside * std::sin(beside.pose.yaw);
  beside.pose.y -= outside * std::cos(beside.pose.yaw);
  const double before = follower.lastCommand().speed;
  return follower.step(beside, costmap, kStepTime).command.speed - before;
}

TEST(PathFollower, slowsDownToComeBackToABendThatItHasLeft)
{
  EXPECT_NEAR(changeOutsideOfBend(0.0), 0.0, 0.01);
  EXPECT_GT(changeOutsideOfBend(-0.3), -0.01) << "inside, where it may steer less";
  EXPECT_LT(changeOutsideOfBend(0.3), -0.03);
}

// By how much a car is told to become faster in a step, m/s, on a way so bent, 1/m, at 2.8 m/s.
double speedingUp(double curvature)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  PathFollower follower(racingFollower());
  const Path path = samplePath({3.0, 4.0, 0.0}, {{10.0, curvature}}, 0.1);
  follower.setPath(path, costmap);
  const CarState car{path[20].pose, 2.8};
  const double before = follower.step(car, costmap, kStepTime).command.speed;
  return follower.step(car, costmap, kStepTime).command.speed - before;
}

TEST(PathFollower, speedsUpWithWhatTheTyresHaveLeftInABend)
{
  EXPECT_NEAR(speedingUp(0.0), 3.0 * kStepTime, 1e-9);
  EXPECT_GT(speedingUp(0.3), 0.3 * 3.0 * kStepTime);
  EXPECT_LT(speedingUp(0.3), 0.8 * 3.0 * kStepTime);
}

FollowerOptions slidingFollower()
{
  FollowerOptions options = racingFollower();
  options.slip_gradient = 0.0178;
  options.limits.understeer_gradient = 0.0028;
  options.load_transfer = 0.0457;
  options.limits.max_lateral_acceleration = 7.5;
  return options;
}

TEST(Handling, countersTheUndersteerOfTheBendThatTheTyresBear)
{
  const Handling handling(slidingFollower());
  const double wheelbase = slidingFollower().limits.wheelbase;
  EXPECT_NEAR(handling.withUndersteer(0.06, 0.0, 10.0, 8.0), 0.06, 1e-9) << "none yet";
  const double steady = std::atan(0.06 * wheelbase) + 0.0028 * 6.0;
  EXPECT_NEAR(handling.withUndersteer(0.06, 0.06, 10.0, 10.0), std::tan(steady) / wheelbase, 1e-9);
  EXPECT_LT(handling.withUndersteer(0.06, 0.06, 10.0, 9.0), 0.05) << "braking unloads the rear axle";
  EXPECT_LT(handling.withUndersteer(0.0, 0.06, 10.0, 9.0), 0.0) << "to come out of a bend";
}

TEST(PathFollower, turnsItsWheelsForABendAheadWhileItBrakes)
{
  FollowerOptions options = slidingFollower();
  options.yaw_lag = 0.05;
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  const Path path = samplePath({2.0, 4.0, 0.0}, {{3.0, 0.0}, {8.0, 0.25}}, 0.1);
  const auto commanded = [&](bool brake) {
    PathFollower follower(options);
    follower.setPath(path, costmap);
    const CarState before{path[26].pose, 4.0};
    follower.step(before, costmap, kStepTime);
    return follower.step(before, costmap, kStepTime, brake).command.curvature;
  };
  EXPECT_GT(commanded(false), 0.2);
  EXPECT_NEAR(commanded(true), commanded(false), 1e-9);
}

// How far beside its path a car comes, m, before it has driven so much of it, m.
double farthestBeside(const FollowerOptions & options, const Path & path, double until)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  PathFollower follower(options);
  follower.setPath(path, costmap);
  KinematicCar car(path.front().pose);
  double farthest = 0.0;
  while (follower.placeOf(car.state()) < until) {
    const FollowStep step = follower.step(car.state(), costmap, kStepTime);
    farthest = std::max(farthest, std::abs(step.position.lateral));
    car.drive(step.command, kStepTime);
  }
  return farthest;
}

// Wheels need a quarter of a second from lock to lock: a car that turns them at the kink leaves this path by 0.16 m.
TEST(PathFollower, turnsItsWheelsInTimeForAKink)
{
  const Path path = samplePath({3.0, 4.0, 0.0}, {{2.0, 0.0}, {0.6, 1.25}, {0.6, -1.25}, {4.0, 0.0}}, 0.1);
  EXPECT_LT(farthestBeside(racingFollower(), path, 5.0), 0.05);
}

FollowerOptions brakingHard()
{
  FollowerOptions options = racingFollower();
  options.limits.acc_lim_x = 7.0;
  options.limits.dec_lim_x = 7.0;
  options.limits.max_lateral_acceleration = 1.5;
  return options;
}

Path leadingIntoAKink()
{
  return samplePath({3.0, 8.0, 0.0}, {{3.0, 0.2}, {0.6, -1.25}, {3.0, 0.0}}, 0.1);
}

TEST(PathFollower, turnsItsWheelsInTimeForAKinkThatItBrakesFor)
{
  EXPECT_LT(farthestBeside(brakingHard(), leadingIntoAKink(), 5.0), 0.025);
}

TEST(PathFollower, turnsItsWheelsForAKinkAsLateAsTheSpeedThereAllows)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  const Path path = leadingIntoAKink();
  PathFollower follower(brakingHard());
  follower.setPath(path, costmap);
  EXPECT_GT(follower.step({path[28].pose, 2.5}, costmap, kStepTime).command.curvature, 0.0) << "it still brakes";
  EXPECT_LT(follower.step({path[30].pose, 1.1}, costmap, kStepTime).command.curvature, -1.0);
}

TEST(PathFollower, keepsItsWheelsTurnedOnceItHasBegunForAKink)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  const Path path = leadingIntoAKink();
  PathFollower follower(brakingHard());
  follower.setPath(path, costmap);
  KinematicCar car(path.front().pose);
  bool turned = false;
  while (follower.placeOf(car.state()) < 3.3) {
    const DriveCommand command = follower.step(car.state(), costmap, kStepTime).command;
    turned = turned || command.curvature < -0.9;
    EXPECT_TRUE(!turned || command.curvature < -0.8) << command.curvature;
    car.drive(command, kStepTime);
  }
  EXPECT_TRUE(turned);
}

// Backwards with one lock and forwards with the other: who starts before the wheels are there is 0.05 m beside its path.
TEST(PathFollower, turnsItsWheelsBeforeItStarts)
{
  FollowerOptions options = racingFollower();
  options.limits.acc_lim_x = 7.0;
  const Path path = samplePath({8.0, 8.0, 0.0}, {{-0.6, -1.25}, {3.0, 1.25}}, 0.1);
  EXPECT_LT(farthestBeside(options, path, 2.0), 0.025);
}

TEST(PathFollower, asksLessOfTyresThatHoldLess)
{
  const Costmap costmap = makeCostmap(drawOval());
  PathFollower follower(racingFollower());
  follower.setPath(samplePath({2.0, 2.0, 0.0}, {{6.0, 0.0}}, 0.1), costmap);
  const SpeedLimits told = follower.options().limits;
  const auto part = [&](const Tyres & tyres) {
    follower.setHandling(follower.lags(), tyres, costmap);
    const SpeedLimits & limits = follower.options().limits;
    return std::pair(
      limits.acc_lim_x / told.acc_lim_x, limits.max_lateral_acceleration / told.max_lateral_acceleration);
  };
  EXPECT_EQ(part({1.1, 0.95, true}), std::pair(1.0, 1.0)) << "as on a usual floor";
  EXPECT_EQ(part({1.0, 1.0, false}), std::pair(1.0, 0.6)) << "until a bend has shown it";
  EXPECT_NEAR(part({2.0, 1.0, true}).second, std::pow(1.15 / 2.0, 1.5), 1e-9) << "they slip";
  EXPECT_NEAR(part({1.0, 0.5, true}).first, 0.85 * 0.5, 1e-9) << "they spin";
  EXPECT_NEAR(part({1.0, 0.5, false}).second, 0.85 * 0.5, 1e-9);
  EXPECT_EQ(part({1.0, 1.0, true}), std::pair(1.0, 1.0));
}

TEST(PathFollower, drivesBendsWithAReserveWhenItAnswersLate)
{
  const Costmap costmap = makeCostmap(drawOval());
  PathFollower follower(racingFollower());
  follower.setPath(samplePath({2.0, 2.0, 0.0}, {{6.0, 0.0}}, 0.1), costmap);
  const double told = racingFollower().limits.max_lateral_acceleration;
  const auto part = [&](double late, const Tyres & tyres) {
    follower.setHandling({racingFollower().latency + late, Handling::kSpeedLag}, tyres, costmap);
    return follower.options().limits.max_lateral_acceleration / told;
  };
  EXPECT_NEAR(part(0.07, {}), 1.0, 1e-9) << "as tyres that slide seem to";
  EXPECT_NEAR(part(0.13, {}), 0.8, 1e-9);
  EXPECT_NEAR(part(0.13, {2.0, 1.0, true}), 0.8 * std::pow(1.15 / 2.0, 1.5), 1e-9);
  EXPECT_NEAR(part(0.13, {1.0, 1.0, false}), 0.6, 1e-9) << "less than that, until a bend has shown the tyres";
  EXPECT_NEAR(part(0.0, {}), 1.0, 1e-9);
}

TEST(PathFollower, steersAsFarAsItsPathBendsBeforeTheTyresAreFelt)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  const Path path = samplePath({3.0, 4.0, 0.0}, {{10.0, 0.15}}, 0.1);
  PathFollower follower(racingFollower());
  follower.setPath(path, costmap);
  follower.setHandling(follower.lags(), {1.0, 1.0, false}, costmap);
  const double lateral = 0.15 * 4.0 * 4.0;
  ASSERT_GT(lateral, follower.options().limits.max_lateral_acceleration)
    << "a car that is too fast for what is planned";
  EXPECT_GE(follower.step({path[20].pose, 4.0}, costmap, kStepTime).command.curvature, 0.15);
}
}  // namespace
}  // namespace f1tenth_racer
