#include "control/path_follower.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include "expect_throws.h"
#include "kinematic_car.h"
#include "rooms.h"

namespace move_base
{
namespace
{
using testing::drawOval;
using testing::drawRoom;
using testing::KinematicCar;
using testing::makeCostmap;
using testing::onOval;
using testing::scanFrom;

constexpr double kStepTime = 0.025;  // s

FollowerOptions racingFollower()
{
  FollowerOptions options;
  options.limits.max_vel_x = 4.0;
  options.limits.max_vel_x_backwards = 0.5;
  options.limits.max_vel_theta = 5.0;
  options.limits.acc_lim_x = 3.0;
  options.limits.dec_lim_x = 3.0;
  return options;
}

Path ovalLap()
{
  return samplePath(onOval(0.0), {{8.0, 0.0}, {3.0 * M_PI, 1.0 / 3.0}, {8.0, 0.0}, {3.0 * M_PI, 1.0 / 3.0}}, 0.1);
}

// Follows to the end of the path; the least clearance and the greatest speed on the way.
struct Drive
{
  double clearance{HUGE_VAL};
  double top_speed{0.0};
  double time{0.0};
  bool ended{false};
  Pose2 end;
};

Drive driveAlong(const Path & path, const Costmap & costmap, const Pose2 & start)
{
  PathFollower follower(racingFollower());
  follower.setPath(path, costmap);
  KinematicCar car(start);
  Drive drive;
  while (drive.time < 60.0 && !drive.ended) {
    const FollowStep step = follower.step(car.state(), costmap, kStepTime);
    EXPECT_FALSE(step.lost) << drive.time;
    drive.ended = step.at_end && std::abs(car.state().speed) < 0.02;
    car.drive(step.command, kStepTime);
    drive.clearance = std::min(drive.clearance, costmap.clearance(car.state().pose));
    drive.top_speed = std::max(drive.top_speed, car.state().speed);
    drive.time += kStepTime;
  }
  drive.end = car.state().pose;
  return drive;
}

TEST(PathFollower, racesAroundAnOvalWithoutTouching)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Drive drive = driveAlong(ovalLap(), costmap, onOval(0.0));
  EXPECT_TRUE(drive.ended);
  EXPECT_GT(drive.clearance, 0.4);
  EXPECT_GT(drive.top_speed, 3.5);
  EXPECT_LT(drive.time, 16.0);
  EXPECT_NEAR(distance(drive.end, onOval(0.0)), 0.0, 0.08);
}

TEST(PathFollower, comesBackToThePathFromBesideIt)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Drive drive = driveAlong(ovalLap(), costmap, {5.0, 2.25, 0.2});
  EXPECT_TRUE(drive.ended);
  EXPECT_GT(drive.clearance, 0.2);
}

TEST(PathFollower, drivesBackAndForth)
{
  const Costmap costmap = makeCostmap(drawRoom(8.0, 8.0));
  const Path path = samplePath({2.0, 4.0, 0.0}, {{2.0, 0.5}, {-1.5, -0.8}, {1.5, 0.0}}, 0.1);
  const Drive drive = driveAlong(path, costmap, {2.0, 4.0, 0.0});
  EXPECT_TRUE(drive.ended);
  EXPECT_NEAR(distance(drive.end, path.back().pose), 0.0, 0.08);
  EXPECT_NEAR(normalizeAngle(drive.end.yaw - path.back().pose.yaw), 0.0, 0.1);
}

TEST(PathFollower, stopsBeforeAnObstacleThatAppears)
{
  Costmap costmap = makeCostmap(drawRoom(14.0, 4.0));
  PathFollower follower(racingFollower());
  follower.setPath(samplePath({1.0, 2.0, 0.0}, {{12.0, 0.0}}, 0.1), costmap);
  KinematicCar car({1.0, 2.0, 0.0});
  bool blocked = false;
  bool stuck = false;
  for (double t = 0.0; t < 10.0; t += kStepTime) {
    if (t > 2.0 && costmap.liveCells().empty()) {
      const double away = 8.0 - car.state().pose.x;
      costmap.observe(scanFrom(car.state().pose, [&](double angle) { return std::abs(angle) < 0.15 ? away : 20.0; }));
    }
    const FollowStep step = follower.step(car.state(), costmap, kStepTime);
    blocked = blocked || step.blocked;
    stuck = step.stuck;
    car.drive(step.command, kStepTime);
  }
  EXPECT_TRUE(blocked);
  EXPECT_TRUE(stuck);
  EXPECT_NEAR(car.state().speed, 0.0, 0.01);
  EXPECT_GT(costmap.clearance(car.state().pose), 0.0);
  EXPECT_GT(car.state().pose.x, 7.0);
}

TEST(PathFollower, keepsItsWheelsTurnedUntilItStandsBeforeAnObstacle)
{
  Costmap costmap = makeCostmap(drawRoom(8.0, 8.0));
  PathFollower follower(racingFollower());
  const Pose2 start{2.0, 2.0, 0.0};
  follower.setPath(samplePath(start, {{6.0, 0.8}}, 0.1), costmap);
  KinematicCar car(start);
  for (double t = 0.0; t < 1.0; t += kStepTime) {
    car.drive(follower.step(car.state(), costmap, kStepTime).command, kStepTime);
  }
  const Pose2 seen_from = car.state().pose;
  costmap.observe(scanFrom(
    seen_from, [&](double angle) { return std::abs(normalizeAngle(angle - seen_from.yaw)) < 0.5 ? 1.2 : 20.0; }));
  FollowStep step;
  for (double t = 0.0; t < 3.0 && !car.state().stands(); t += kStepTime) {
    step = follower.step(car.state(), costmap, kStepTime);
    EXPECT_GT(step.command.yawRate() / step.command.speed, 0.5) << t;
    car.drive(step.command, kStepTime);
  }
  EXPECT_TRUE(step.stuck);
  EXPECT_TRUE(car.state().stands());
  EXPECT_EQ(follower.step(car.state(), costmap, kStepTime).command.speed, 0.0);
}

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

TEST(PathFollower, asksLessOfTyresThatHoldLess)
{
  const Costmap costmap = makeCostmap(drawOval());
  PathFollower follower(racingFollower());
  follower.setPath(samplePath({2.0, 2.0, 0.0}, {{6.0, 0.0}}, 0.1), costmap);
  const SpeedLimits told = follower.options().limits;
  const auto part = [&](const Tyres & tyres) {
    follower.setTyres(tyres, costmap);
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

TEST(PathFollower, steersAsFarAsItsPathBendsBeforeTheTyresAreFelt)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 16.0));
  const Path path = samplePath({3.0, 4.0, 0.0}, {{10.0, 0.15}}, 0.1);
  PathFollower follower(racingFollower());
  follower.setPath(path, costmap);
  follower.setTyres({1.0, 1.0, false}, costmap);
  const double lateral = 0.15 * 4.0 * 4.0;
  ASSERT_GT(lateral, follower.options().limits.max_lateral_acceleration)
    << "a car that is too fast for what is planned";
  EXPECT_GE(follower.step({path[20].pose, 4.0}, costmap, kStepTime).command.curvature, 0.15);
}

TEST(PathFollower, mayLearnThatTheCarAnswersAtOnce)
{
  const Costmap costmap = makeCostmap(drawOval());
  for (double latency = 0.0001; latency < 0.025; latency += 0.0001) {
    PathFollower follower(racingFollower());
    follower.setPath(ovalLap(), costmap);
    for (const double known : {latency, latency, 0.0, 0.0}) {
      follower.setLags({known, Handling::kSpeedLag});
      EXPECT_TRUE(std::isfinite(follower.step({onOval(0.0), 1.0}, costmap, kStepTime).command.speed));
    }
  }
}

TEST(PathFollower, brakesAlongThePathWhenTold)
{
  const Costmap costmap = makeCostmap(drawOval());
  PathFollower follower(racingFollower());
  follower.setPath(ovalLap(), costmap);
  KinematicCar car(onOval(0.0));
  for (double t = 0.0; t < 8.0; t += kStepTime) {
    car.drive(follower.step(car.state(), costmap, kStepTime, t > 3.0).command, kStepTime);
  }
  EXPECT_NEAR(car.state().speed, 0.0, 0.01);
  EXPECT_GT(costmap.clearance(car.state().pose), 0.4);
}

TEST(PathFollower, saysThatItIsLostFarFromThePath)
{
  const Costmap costmap = makeCostmap(drawOval());
  PathFollower follower(racingFollower());
  follower.setPath(ovalLap(), costmap);
  const FollowStep step = follower.step({{6.0, 2.6, 0.0}, 0.0}, costmap, kStepTime);
  EXPECT_TRUE(step.lost);
  EXPECT_EQ(step.command.speed, 0.0);
}

TEST(PathFollower, neverSteersBeyondTheCarsLimit)
{
  const Costmap costmap = makeCostmap(drawRoom(8.0, 8.0));
  PathFollower follower(racingFollower());
  follower.setPath(samplePath({2.0, 4.0, 0.0}, {{3.0, 0.0}}, 0.1), costmap);
  const FollowStep step = follower.step({{2.0, 4.4, 0.8}, 1.0}, costmap, kStepTime);
  EXPECT_NEAR(step.command.curvature, -std::tan(0.4189) / 0.3302, 1e-9);
}

TEST(FollowerOptions, areChecked)
{
  FollowerOptions options;
  options.max_steering_angle = 2.0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "max_steering_angle: found 2, must be above 0 and below pi/2");
  options = {};
  options.latency = -0.1;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "latency: found -0.1, must be a number of at least 0");
}
}  // namespace
}  // namespace move_base
