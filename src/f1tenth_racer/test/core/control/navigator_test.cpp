#include <move_base/control/navigator.h>

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include "expect_throws.h"
#include "journey.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawMap;
using testing::drawOval;
using testing::drawRoom;
using testing::inRectangle;
using testing::Journey;
using testing::JourneyOptions;
using testing::kCycle;
using testing::makeCostmap;
using testing::onOval;
using testing::racingJourney;
using testing::scanFrom;

const std::vector<std::string> kAllRecoveries{"conservative_reset", "back_up", "aggressive_reset", "back_up"};

TEST(Navigator, reachesAGoalAndStandsThere)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(20.0), journey.time);
  const Outcome outcome = journey.untilOutcome();
  EXPECT_TRUE(outcome.succeeded);
  EXPECT_EQ(outcome.text, "Goal reached.");
  EXPECT_EQ(journey.command.speed, 0.0);
  EXPECT_LT(std::abs(journey.car.state().speed), 0.05);
  EXPECT_LT(distance(journey.car.state().pose, onOval(20.0)), 0.1);
  EXPECT_FALSE(journey.navigator.active());
  EXPECT_EQ(journey.cycle().command->speed, 0.0) << "said again";
  for (const double end = journey.time + 1.0; journey.time < end;) {
    journey.cycle();
  }
  EXPECT_FALSE(journey.cycle().command) << "somebody else may drive it";
}

// A car on the oval whose goal is cancelled after 2 s.
class CancelledJourney : public Journey
{
public:
  CancelledJourney() : Journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0))
  {
    navigator.setGoal(onOval(20.0), time);
    for (int i = 0; i < 40; ++i) {
      cycle();
    }
    navigator.cancel();
  }
};

TEST(Navigator, tellsACarThatIsStoppedSoAgainAndAgain)
{
  CancelledJourney journey;
  for (int i = 0; i < 15; ++i) {
    const auto command = journey.cycle().command;
    ASSERT_TRUE(command) << i;
    EXPECT_EQ(command->speed, 0.0);
  }
}

TEST(Navigator, tellsAStoppedCarSoAlsoWhenTimeJumpsBack)
{
  CancelledJourney journey;
  journey.cycle();
  journey.time = 1.0;
  const auto command = journey.cycle().command;
  ASSERT_TRUE(command);
  EXPECT_EQ(command->speed, 0.0);
}

TEST(Navigator, hasPatienceWhenWhatFollowsTheGoalChanges)
{
  JourneyOptions options = racingJourney();
  options.free_goal_vel = true;
  Journey journey(options, makeCostmap(drawRoom(60.0, 3.0)), {1.0, 1.5, 0.0});
  const Pose2 goal{50.0, 1.5, 0.0};
  journey.navigator.setGoal(goal, journey.time);
  for (const double end = journey.time + 3.0 * options.planner_patience; journey.time < end;) {
    journey.cycle();
  }
  const Pose2 eye{goal.x - 3.0, goal.y, 0.0};
  journey.costmap().observe(scanFrom(eye, [](double angle) { return std::abs(angle) < 0.3 ? 3.0 : 20.0; }));
  journey.navigator.setNextGoals({{58.0, 1.5, 0.0}});
  for (const double end = journey.time + 0.8 * options.planner_patience; journey.time < end;) {
    journey.cycle();
  }
  EXPECT_TRUE(journey.recoveries.empty());
}

// A car whose goal something stands at that is on no map.
class JourneyToATakenGoal : public Journey
{
public:
  explicit JourneyToATakenGoal(const JourneyOptions & options)
  : Journey(options, makeCostmap(drawRoom(8.0, 3.0)), {2.0, 1.5, 0.0})
  {
    scan = scanFrom({3.0, 1.5, 0.0}, [](double angle) { return std::abs(angle) < 0.2 ? 1.0 : 20.0; });
    navigator.setGoal({4.0, 1.5, 0.0}, time);
  }
};

constexpr char kTaken[] = "The lidar sees something at the goal.";
const std::string kNoPlanForTaken =
  std::string("Failed to find a valid plan. Even after executing recovery behaviors. ") + kTaken;

TEST(Navigator, abortsWithoutAPlanAfterAllRecoveries)
{
  JourneyToATakenGoal journey(racingJourney());
  EXPECT_EQ(journey.cycle().trouble, kTaken) << "at once";
  const Outcome outcome = journey.untilOutcome();
  EXPECT_FALSE(outcome.succeeded);
  EXPECT_EQ(outcome.text, kNoPlanForTaken);
  EXPECT_EQ(journey.recoveries, kAllRecoveries);
  EXPECT_EQ(journey.command.speed, 0.0);
}

TEST(Navigator, abortsAtOnceWithoutRecoveryBehaviors)
{
  JourneyOptions options = racingJourney();
  options.recovery_behavior_enabled = false;
  options.max_planning_retries = 0;
  JourneyToATakenGoal journey(options);
  EXPECT_EQ(journey.untilOutcome(0.1).text, kNoPlanForTaken);
  EXPECT_TRUE(journey.recoveries.empty());
}

TEST(Navigator, triesTheRecoveriesThatItIsTold)
{
  JourneyOptions options = racingJourney();
  options.recoveries = defaultRecoveries(3.0, false);
  JourneyToATakenGoal journey(options);
  journey.untilOutcome();
  EXPECT_EQ(journey.recoveries, (std::vector<std::string>{"conservative_reset", "aggressive_reset"}));
  EXPECT_NEAR(distance(journey.car.state().pose, Pose2{2.0, 1.5, 0.0}), 0.0, 1e-9);
}

const std::string kReachesOver = "At the goal the car would touch a wall, or reach into where the map is unknown.";

struct Unreachable
{
  Pose2 goal;
  std::string reason;
};

class NavigatorWithoutAWay : public ::testing::TestWithParam<Unreachable>
{
};

TEST_P(NavigatorWithoutAWay, abortsAtOnceAndSaysWhy)
{
  OccupancyGrid map = drawOval();
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const Vec2 at = map.geometry.centre(map.geometry.cell(i));
    map.cells[i] = inRectangle(at, {8.5, 4.0}, {9.5, 6.0}) ? -1 : map.cells[i];
    map.cells[i] = inRectangle(at, {4.0, 4.2}, {6.0, 5.8}) ? 0 : map.cells[i];
    map.cells[i] = inRectangle(at, {5.6, 4.2}, {6.0, 5.8}) ? -1 : map.cells[i];
  }
  Journey journey(racingJourney(), makeCostmap(map), onOval(0.0));
  journey.navigator.setGoal(GetParam().goal, journey.time);
  const CycleOutput output = journey.cycle();
  ASSERT_TRUE(output.outcome);
  EXPECT_FALSE(output.outcome->succeeded);
  EXPECT_EQ(output.outcome->text, "Failed to find a valid plan. " + GetParam().reason);
  EXPECT_EQ(output.command->speed, 0.0);
  EXPECT_TRUE(journey.recoveries.empty());
}

INSTANTIATE_TEST_SUITE_P(
  Goals, NavigatorWithoutAWay,
  ::testing::Values(
    Unreachable{{7.5, 5.0, 0.0}, "The goal is in a wall."}, Unreachable{{9.0, 1.25, 0.0}, kReachesOver},
    Unreachable{{30.0, 5.0, 0.0}, "The goal is outside of the map."},
    Unreachable{{9.0, 5.0, 0.0}, "The map is unknown at the goal."}, Unreachable{{5.3, 5.0, 0.0}, kReachesOver},
    Unreachable{{5.0, 5.0, 0.0}, "No way leads to the goal."}));

TEST(Navigator, saysHowToStartElsewhereThanInAWall)
{
  Journey journey(racingJourney(), makeCostmap(drawRoom(14.0, 2.0)), {1.0, 0.1, 0.0});
  journey.navigator.setGoal({11.0, 1.0, 0.0}, journey.time);
  const std::string trouble = journey.cycle().trouble;
  EXPECT_NE(trouble.find("The car stands in a wall of the map"), std::string::npos) << trouble;
  EXPECT_NE(trouble.find("x:= y:= yaw:="), std::string::npos) << trouble;
}

TEST(Navigator, saysWhatTheLidarSeesInItsWay)
{
  for (const auto & [ahead, reason] :
       {std::pair{11.0, "The lidar sees something at the goal."},
        std::pair{6.0, "What the lidar sees closes the way to the goal."}}) {
    Journey journey(racingJourney(), makeCostmap(drawRoom(14.0, 2.0)), {1.0, 1.0, 0.0});
    const double away = ahead;
    journey.costmap().observe(scanFrom(
      {ahead - 1.0, 1.0, 0.0}, [&](double angle) { return std::abs(angle) < 0.75 ? 1.0 / std::cos(angle) : 20.0; }));
    journey.navigator.setGoal({11.0, 1.0, 0.0}, journey.time);
    const CycleOutput output = journey.cycle();
    EXPECT_FALSE(output.outcome) << "it may go away";
    EXPECT_EQ(output.trouble, reason) << away;
  }
}

TEST(Navigator, abortsWithoutControlWhereTheFollowerSeesNoWay)
{
  // The planner goes through a gap as wide as the car, the follower wants 0.3 m.
  JourneyOptions options = racingJourney();
  options.follower.stop_clearance = 0.3;
  const OccupancyGrid gap = drawMap(8.0, 3.0, [](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {7.9, 2.9}) || (std::abs(p.x - 4.0) < 0.2 && std::abs(p.y - 1.5) > 0.3);
  });
  Journey journey(options, makeCostmap(gap), {1.0, 1.5, 0.0});
  journey.navigator.setGoal({7.0, 1.5, 0.0}, journey.time);
  EXPECT_EQ(
    journey.untilOutcome(120.0).text, "Failed to find a valid control. Even after executing recovery behaviors.");
  EXPECT_EQ(journey.recoveries, kAllRecoveries);
}

TEST(Navigator, abortsWithoutControlOfACarThatDoesNotMove)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.wheels_grip = false;
  journey.navigator.setGoal(onOval(6.0), journey.time);
  EXPECT_EQ(
    journey.untilOutcome(30.0).text, "Failed to find a valid control. Even after executing recovery behaviors.");
  EXPECT_EQ(journey.recoveries, kAllRecoveries);
}

TEST(Navigator, saysThatTheCarDoesNotMoveThoughItIsToldTo)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.wheels_grip = false;
  journey.navigator.setGoal(onOval(6.0), journey.time);
  const double end = journey.time + 1.5;
  std::string trouble;
  while (journey.time < end) {
    trouble = journey.cycle().trouble;
  }
  EXPECT_EQ(trouble, "The car does not move though it is told to.");
}

TEST(Navigator, abortsWhenTheCarDoesNotGetAnywhere)
{
  JourneyOptions options = racingJourney();
  options.oscillation_timeout = 1.0;
  Journey journey(options, makeCostmap(drawOval()), onOval(0.0));
  journey.wheels_grip = false;
  journey.navigator.setGoal(onOval(6.0), journey.time);
  EXPECT_EQ(journey.untilOutcome().text, "Robot is oscillating. Even after executing recovery behaviors.");
  EXPECT_EQ(journey.recoveries, kAllRecoveries);
}

TEST(Navigator, followsItsPathByPosesThatComeLate)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.delay = 4;
  journey.navigator.setGoal(onOval(20.0), journey.time);
  EXPECT_TRUE(journey.untilOutcome().succeeded);
  EXPECT_GT(journey.clearance, 0.3);
}

TEST(Navigator, plansAroundAnObstacleThatAppears)
{
  Journey journey(racingJourney(), makeCostmap(drawRoom(14.0, 4.0)), {1.0, 2.0, 0.0});
  journey.navigator.setGoal({13.0, 2.0, 0.0}, journey.time);
  int plans = 0;
  Outcome outcome{false, "nothing"};
  for (int i = 0; i < 400 && outcome.text == "nothing"; ++i) {
    if (i == 20) {
      const Pose2 eye = journey.car.state().pose;
      const double away = 8.0 - eye.x;
      journey.costmap().observe(scanFrom(eye, [&](double angle) { return std::abs(angle) < 0.06 ? away : 20.0; }));
    }
    const CycleOutput output = journey.cycle();
    plans += output.new_plan ? 1 : 0;
    outcome = output.outcome.value_or(outcome);
  }
  EXPECT_TRUE(outcome.succeeded);
  EXPECT_GE(plans, 2);
  EXPECT_GT(journey.clearance, 0.0);
}

TEST(Navigator, aNewGoalTakesOverWhileDriving)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(6.0), journey.time);
  for (int i = 0; i < 20; ++i) {
    journey.cycle();
  }
  journey.navigator.setGoal(onOval(12.0), journey.time);
  const CycleOutput output = journey.cycle();
  EXPECT_TRUE(output.new_plan);
  EXPECT_GT(output.command->speed, 1.5) << "without a stop";
  EXPECT_TRUE(journey.untilOutcome().succeeded);
  EXPECT_LT(distance(journey.car.state().pose, onOval(12.0)), 0.2);
}

TEST(Navigator, brakesAlongTheOldPathWhenThereIsNoPlanForTheNewGoal)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(6.0));
  journey.navigator.setGoal(onOval(16.0), journey.time);
  for (int i = 0; i < 30; ++i) {
    journey.cycle();
  }
  EXPECT_GT(journey.car.state().speed, 2.0);
  journey.navigator.setGoal({9.0, 5.0, 0.0}, journey.time);
  EXPECT_TRUE(journey.cycle().outcome) << "said at once";
  while (journey.cycle().command) {
  }
  EXPECT_LT(std::abs(journey.car.state().speed), 0.05);
  EXPECT_GT(journey.clearance, 0.3);
}

// Patience with a plan begins when it fails, not when the last one was made.
TEST(Navigator, comesToAStandInTheBendBeforeItRecovers)
{
  JourneyOptions options = racingJourney();
  options.planner_patience = 0.3;
  options.planner.max_expansions = 5000;
  Journey journey(options, makeCostmap(drawOval()), onOval(6.0));
  const auto closeRoadAhead = [&](const Pose2 & from) {
    journey.costmap().observe(scanFrom(from, [&](double angle) {
      const double off = std::abs(normalizeAngle(angle - from.yaw));
      return off < 0.9 ? 1.0 / std::cos(off) : 0.0;
    }));
  };
  journey.navigator.setGoal(onOval(24.0), journey.time);
  for (int i = 0; i < 30; ++i) {
    journey.cycle();
  }
  EXPECT_GT(journey.car.state().speed, 2.0);
  closeRoadAhead(onOval(14.0));
  closeRoadAhead(compose(onOval(4.0), {0.0, 0.0, M_PI}));
  while (journey.recoveries.empty()) {
    journey.cycle();
  }
  EXPECT_LT(journey.car.state().speed, 0.1);
  EXPECT_GT(journey.clearance, 0.45);
}

TEST(Navigator, brakesNoHarderThanItMayBeforeItRecovers)
{
  JourneyOptions options = racingJourney();
  options.oscillation_timeout = 1.5;
  options.oscillation_distance = 1000.0;
  Journey journey(options, makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(18.0), journey.time);
  double fastest = 0.0;
  while (journey.recoveries.empty()) {
    const double before = journey.command.speed;
    journey.cycle();
    fastest = std::max(fastest, before);
    ASSERT_LE(before - journey.command.speed, (options.follower.limits.dec_lim_x + 0.1) * kCycle);
  }
  EXPECT_GT(fastest, 2.0);
  EXPECT_LT(journey.car.state().speed, 0.1);
}

TEST(Navigator, drivesTheSameWayEveryTime)
{
  std::vector<Pose2> ends;
  for (int i = 0; i < 2; ++i) {
    Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
    journey.navigator.setGoal(onOval(18.0), journey.time);
    ASSERT_TRUE(journey.untilOutcome().succeeded);
    ends.push_back(journey.car.state().pose);
  }
  EXPECT_EQ(ends[0].x, ends[1].x);
  EXPECT_EQ(ends[0].y, ends[1].y);
  EXPECT_EQ(ends[0].yaw, ends[1].yaw);
}

TEST(NavigatorOptions, areChecked)
{
  NavigatorOptions options;
  options.max_planning_retries = -2;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "max_planning_retries: found -2, must be at least -1");
}

TEST(RacerOptions, areChecked)
{
  RacerOptions options;
  options.planner.min_turning_radius = 0.5;
  EXPECT_THROWS_MESSAGE(
    options.validate(), OptionError,
    "min_turning_radius: found 0.5, must be at least wheelbase / tan(max_steering_angle) = 0.741599");
  options = {};
  options.goal_tolerance.distance = 0.0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "xy_goal_tolerance: found 0, must be a number above 0");
}
}  // namespace
}  // namespace f1tenth_racer
