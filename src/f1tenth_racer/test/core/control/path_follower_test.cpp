#include "control/path_follower.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include "expect_throws.h"
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
using testing::onOval;
using testing::racingFollower;
using testing::scanFrom;

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

TEST(PathFollower, mayLearnThatTheCarAnswersAtOnce)
{
  const Costmap costmap = makeCostmap(drawOval());
  for (double latency = 0.0001; latency < 0.025; latency += 0.0001) {
    PathFollower follower(racingFollower());
    follower.setPath(ovalLap(), costmap);
    for (const double known : {latency, latency, 0.0, 0.0}) {
      follower.setHandling({known, Handling::kSpeedLag}, {}, costmap);
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
  options.latency = -0.1;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "latency: found -0.1, must be a number of at least 0");
}
}  // namespace
}  // namespace f1tenth_racer
