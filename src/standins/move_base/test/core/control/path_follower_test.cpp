#include "move_base/control/path_follower.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "expect_throws.h"
#include "move_base/control/navigator.h"
#include "move_base/planning/way_planner.h"
#include "rooms.h"

namespace move_base
{
namespace
{
using testing::drawOval;
using testing::drawRoom;
using testing::makeCostmap;
using testing::onOval;
using testing::scanFrom;

constexpr double kCycle = 0.05;  // s
const std::vector<std::string> kAllRecoveries{"conservative_reset", "back_up", "aggressive_reset", "back_up"};

PathFollowerOptions brisk()
{
  PathFollowerOptions options;
  options.max_vel_x = 2.0;
  options.max_vel_theta = 3.0;
  options.acc_lim_x = 2.0;
  return options;
}

// A car that does as it is told, with the plain planners.
class Drive
{
public:
  Drive(Costmap costmap, const Pose2 & start, const PathFollowerOptions & options = brisk())
  : navigator({}, std::make_unique<WayPlanner>(PlannerOptions{}), std::make_unique<PathFollower>(options)),
    costmap_(std::move(costmap))
  {
    car.pose = start;
  }

  CycleOutput cycle()
  {
    CycleOutput output = navigator.cycle({time, car, sensors_current}, costmap_);
    const DriveCommand command = output.command.value_or(DriveCommand{});
    car.speed = command.speed;
    car.pose = advance(car.pose, command.speed * kCycle, command.curvature);
    time += kCycle;
    fastest = std::max(fastest, car.speed);
    clearance = std::min(clearance, costmap_.clearance(car.pose));
    if (output.recovery) {
      recoveries.push_back(output.recovery->name);
    }
    return output;
  }

  Outcome untilOutcome()
  {
    for (const double end = time + 120.0; time < end;) {
      if (const auto outcome = cycle().outcome) {
        return *outcome;
      }
    }
    return {false, "nothing within the limit"};
  }

  Costmap & costmap() { return costmap_; }

  Navigator navigator;
  CarState car;
  double time{10.0};
  bool sensors_current{true};
  double fastest{0.0};
  double clearance{HUGE_VAL};
  std::vector<std::string> recoveries;

private:
  Costmap costmap_;
};

TEST(PathFollower, takesACarRoundTheBendsToAStandAtItsGoal)
{
  Drive drive(makeCostmap(drawOval()), onOval(0.0));
  drive.navigator.setGoal(onOval(15.0), drive.time, {onOval(19.0)});
  EXPECT_TRUE(drive.untilOutcome().succeeded);
  EXPECT_TRUE(drive.car.stands());
  EXPECT_LT(distance(drive.car.pose, onOval(15.0)), 0.2);
  EXPECT_LT(std::abs(normalizeAngle(drive.car.pose.yaw - onOval(15.0).yaw)), 0.2);
  EXPECT_GT(drive.fastest, 1.9);
  EXPECT_GT(drive.clearance, 0.3);
}

TEST(PathFollower, backsUpToAGoalBehindIt)
{
  Drive drive(makeCostmap(drawRoom(8.0, 1.8)), {4.0, 0.9, 0.0});
  drive.navigator.setGoal({2.5, 0.9, 0.0}, drive.time);
  EXPECT_TRUE(drive.untilOutcome().succeeded);
  EXPECT_EQ(drive.fastest, 0.0);
  EXPECT_NEAR(drive.car.pose.x, 2.5, 0.2);
}

TEST(PathFollower, plansAroundWhatAppearsOnItsWay)
{
  Drive drive(makeCostmap(drawRoom(14.0, 4.0)), {1.0, 2.0, 0.0});
  drive.navigator.setGoal({12.0, 2.0, 0.0}, drive.time);
  while (drive.car.speed < 1.5) {
    drive.cycle();
  }
  const double away = 7.0 - drive.car.pose.x;
  drive.navigator.observe(
    scanFrom(drive.car.pose, [&](double angle) { return std::abs(angle) < 0.05 ? away : 20.0; }), drive.costmap());
  EXPECT_TRUE(drive.untilOutcome().succeeded);
  EXPECT_GT(drive.clearance, 0.0);
}

TEST(PathFollower, stopsBeforeWhatClosesItsWay)
{
  Drive drive(makeCostmap(drawRoom(14.0, 1.4)), {1.0, 0.7, 0.0});
  drive.navigator.setGoal({12.0, 0.7, 0.0}, drive.time);
  while (drive.car.speed < 1.5) {
    drive.cycle();
  }
  const Pose2 eye = drive.car.pose;
  drive.navigator.observe(
    scanFrom(eye, [&](double angle) { return std::abs(angle) < 0.25 ? (6.0 - eye.x) / std::cos(angle) : 20.0; }),
    drive.costmap());
  for (int i = 0; i < 60; ++i) {
    drive.cycle();
  }
  EXPECT_TRUE(drive.car.stands());
  EXPECT_GT(drive.clearance, 0.0);
  EXPECT_LT(drive.car.pose.x, 6.0);
}

TEST(PathFollower, brakesWithoutSensors)
{
  Drive drive(makeCostmap(drawOval()), onOval(0.0));
  drive.navigator.setGoal(onOval(20.0), drive.time);
  while (drive.car.speed < 1.5) {
    drive.cycle();
  }
  drive.sensors_current = false;
  for (int i = 0; i < 25; ++i) {
    drive.cycle();
  }
  EXPECT_EQ(drive.car.speed, 0.0);
}

TEST(Navigator, abortsWithoutAPlanAfterAllRecoveries)
{
  Drive drive(makeCostmap(drawRoom(8.0, 3.0)), {2.0, 1.5, 0.0});
  const auto block = [&] {
    drive.navigator.observe(
      scanFrom({3.0, 1.5, 0.0}, [](double angle) { return std::abs(angle) < 0.2 ? 1.0 : 20.0; }), drive.costmap());
  };
  drive.navigator.setGoal({4.0, 1.5, 0.0}, drive.time);
  std::optional<Outcome> outcome;
  for (int i = 0; i < 4000 && !outcome; ++i) {
    block();
    outcome = drive.cycle().outcome;
  }
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(outcome->succeeded);
  EXPECT_EQ(
    outcome->text,
    "Failed to find a valid plan. Even after executing recovery behaviors. The lidar sees something at the goal.");
  EXPECT_EQ(drive.recoveries, kAllRecoveries);
}

TEST(PathFollowerOptions, areChecked)
{
  PathFollowerOptions options;
  options.min_vel_x = 3.0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "min_vel_x: found 3, must be above 0 and at most max_vel_x");
}
}  // namespace
}  // namespace move_base
