#include <move_base/control/navigator.h>

#include <gtest/gtest.h>

#include "journey.h"

// Cars whose sensors fall silent.
namespace f1tenth_racer
{
namespace
{
using testing::drawOval;
using testing::drawRoom;
using testing::Journey;
using testing::JourneyOptions;
using testing::kCycle;
using testing::KinematicCar;
using testing::makeCostmap;
using testing::onOval;
using testing::racingJourney;

// Which of what the car knows of itself is as it was when the sensors fell silent.
struct Silence
{
  double speed;
  bool pose_old;
  bool speed_old;
};

class NavigatorInSilence : public ::testing::TestWithParam<Silence>
{
};

TEST_P(NavigatorInSilence, brakesToAStandFromItsSpeed)
{
  const auto [speed, pose_old, speed_old] = GetParam();
  JourneyOptions options = racingJourney();
  options.follower.limits.max_vel_x = speed;
  Journey journey(options, makeCostmap(drawRoom(60.0, 4.0)), {1.0, 2.0, 0.0});
  journey.navigator.setGoal({58.0, 2.0, 0.0}, journey.time);
  while (journey.car.state().speed < 0.95 * speed) {
    journey.cycle();
  }
  const CarState last = journey.car.state();
  const double since = journey.time;
  const double braking = speed / options.follower.limits.dec_lim_x + 0.6;
  double least = speed;
  for (int i = 0; i < 200; ++i) {
    CycleInput input{journey.time, journey.car.state(), false, 0.0, 0.0};
    input.car.pose = pose_old ? last.pose : input.car.pose;
    input.age = pose_old ? journey.time - since : 0.0;
    input.car.speed = speed_old ? last.speed : input.car.speed;
    input.speed_age = speed_old ? journey.time - since : 0.0;
    const auto command = journey.navigator.cycle(input, journey.costmap()).command;
    ASSERT_TRUE(command) << i;
    EXPECT_LE(command->speed, least + 0.05) << i;
    least = std::min(least, command->speed);
    journey.car.drive(*command, kCycle);
    journey.time += kCycle;
    EXPECT_TRUE(journey.time < since + braking || (command->speed == 0.0 && journey.car.state().speed < 0.05)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
  EverySpeed, NavigatorInSilence,
  ::testing::Values(
    Silence{1.0, false, true}, Silence{1.0, true, false}, Silence{1.0, true, true}, Silence{1.0, false, false},
    Silence{4.0, false, true}, Silence{4.0, true, false}, Silence{4.0, true, true}, Silence{4.0, false, false},
    Silence{8.0, false, true}, Silence{8.0, true, false}, Silence{8.0, true, true}, Silence{8.0, false, false}));

TEST(Navigator, doesNotTakeTheTimeWithoutSensorsForGettingNowhere)
{
  JourneyOptions options = racingJourney();
  options.oscillation_timeout = 2.0;
  Journey journey(options, makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(20.0), journey.time);
  for (const int cycles : {40, 100}) {
    for (int i = 0; i < cycles; ++i) {
      journey.cycle();
    }
    journey.sensors_current = !journey.sensors_current;
  }
  EXPECT_TRUE(journey.untilOutcome().succeeded);
  EXPECT_TRUE(journey.recoveries.empty());
}

TEST(Navigator, brakesInTheBendWhileSensorsAreStaleAndGoesOnAfterwards)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(20.0), journey.time);
  while (journey.car.state().pose.x < 14.0) {
    journey.cycle();
  }
  EXPECT_GT(journey.car.state().speed, 2.0);
  const double clearance = journey.clearance;
  journey.sensors_current = false;
  for (int i = 0; i < 40; ++i) {
    ASSERT_TRUE(journey.cycle().command);
    EXPECT_TRUE(i < 30 || (journey.command.speed == 0.0 && journey.car.state().speed < 0.05)) << i;
  }
  EXPECT_GT(journey.clearance, clearance - 0.1) << "it stays on the road";
  journey.sensors_current = true;
  EXPECT_TRUE(journey.untilOutcome().succeeded);
  EXPECT_GT(journey.clearance, 0.3);
}

TEST(Navigator, brakesByDeadReckoningWhenItsPoseIsOld)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(20.0), journey.time);
  while (journey.car.state().pose.x < 14.0) {
    journey.cycle();
  }
  const CarState last_seen = journey.car.state();
  const double last_time = journey.time;
  KinematicCar car = journey.car;
  Costmap & costmap = journey.costmap();
  double clearance = HUGE_VAL;
  for (double time = last_time; time < last_time + 2.0; time += kCycle) {
    const auto output = journey.navigator.cycle({time, last_seen, false, time - last_time, time - last_time}, costmap);
    ASSERT_TRUE(output.command);
    car.drive(*output.command, kCycle);
    clearance = std::min(clearance, costmap.clearance(car.state().pose));
  }
  EXPECT_LT(car.state().speed, 0.05);
  EXPECT_GT(distance(car.state().pose, last_seen.pose), 0.5);
  EXPECT_GT(clearance, 0.3);
}
}  // namespace
}  // namespace f1tenth_racer
