// Where a car stops, and which goals it only passes.
#include "path/goals.h"

#include <gtest/gtest.h>

#include "journey.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawOval;
using testing::drawRoom;
using testing::Journey;
using testing::JourneyOptions;
using testing::makeCostmap;
using testing::onOval;
using testing::racingJourney;
using testing::scanFrom;

JourneyOptions passingNavigator()
{
  JourneyOptions options = racingJourney();
  options.free_goal_vel = true;
  return options;
}

void expectStandsAt(const Journey & journey, const Pose2 & goal)
{
  const CarState & car = journey.car.state();
  EXPECT_LT(std::abs(car.speed), 0.06);
  EXPECT_LT(distance(car.pose, goal), 0.2);
  EXPECT_LT(std::abs(normalizeAngle(car.pose.yaw - goal.yaw)), 0.2);
  EXPECT_GT(journey.clearance, 0.2);
}

TEST(Goals, areNearWhereTheWayBetweenTwoPosesPassesThem)
{
  const GoalTolerance tolerance{0.2, 0.3};
  EXPECT_TRUE(cameNear({0.0, 0.1, 0.0}, {1.0, 0.1, 0.0}, {0.5, 0.0, 0.2}, tolerance));
  EXPECT_FALSE(cameNear({0.0, 0.3, 0.0}, {1.0, 0.3, 0.0}, {0.5, 0.0, 0.0}, tolerance));
  EXPECT_FALSE(cameNear({0.0, 0.1, 0.0}, {1.0, 0.1, 0.0}, {0.5, 0.0, 0.4}, tolerance));
  EXPECT_FALSE(cameNear({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.3, 0.0, 0.0}, tolerance));
  EXPECT_TRUE(cameNear({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.1, 0.0, 0.0}, tolerance));
}

TEST(Goals, knowTheWayToTheLastOneUnlessTheyGoRound)
{
  Goals goals;
  goals.set({0.0, 0.0, 0.0}, {});
  EXPECT_EQ(goals.wayToLast(), 0.0);
  goals.setNext({{3.0, 0.0, 0.0}, {3.0, 4.0, 0.0}});
  EXPECT_EQ(goals.wayToLast(), 7.0);
  goals.setNext({{3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}});
  EXPECT_EQ(goals.wayToLast(), HUGE_VAL);
  goals.move({0.0, 0.3, 0.0});
  EXPECT_EQ(goals.wayToLast(), HUGE_VAL) << "also when the goal has given way";
}

TEST(Goals, giveWayToTheSideOnTheRoad)
{
  for (const double width : {3.0, 0.7}) {
    Costmap costmap = makeCostmap(drawRoom(12.0, width));
    const double middle = 0.5 * width;
    costmap.observe(scanFrom({2.0, middle, 0.0}, [](double angle) { return std::abs(angle) < 0.05 ? 3.0 : 9.5; }));
    Goals goals;
    goals.set({4.8, middle, 0.0}, {{8.0, middle, 0.0}});
    EXPECT_EQ(goals.moveAside(costmap, 0.1), width > 1.0);
    const double aside = std::abs(goals.front().y - middle);
    if (width > 1.0) {
      EXPECT_GE(costmap.clearance(goals.front()), 0.1);
      EXPECT_LT(aside, 0.8);
    } else {
      EXPECT_EQ(aside, 0.0) << "behind a wall is no place";
    }
  }
}

TEST(Navigator, isAtALoneGoalOnlyWhereItStands)
{
  const Pose2 goal{6.0, 2.0, 0.0};
  for (const double off : {0.19, 0.21}) {
    testing::RacingNavigator navigator(racingJourney());
    Costmap costmap = makeCostmap(drawRoom(12.0, 4.0));
    navigator.setGoal(goal, 0.0);
    EXPECT_FALSE(navigator.cycle({0.05, {{goal.x - 0.1, goal.y, 0.0}, 0.4}, true}, costmap).outcome);
    const auto outcome = navigator.cycle({0.1, {{goal.x + off, goal.y, 0.0}, 0.0}, true}, costmap).outcome;
    EXPECT_EQ(outcome.has_value(), off < 0.2) << "the way there does not count";
  }
}

TEST(Navigator, passesGoalsThatAnotherOneFollowsWithoutStopping)
{
  Journey journey(passingNavigator(), makeCostmap(drawOval()), onOval(0.0));
  double slowest = HUGE_VAL;
  for (int i = 1; i <= 14; ++i) {
    journey.navigator.setGoal(onOval(5.0 * i), journey.time, {onOval(5.0 * i + 5.0), onOval(5.0 * i)});
    ASSERT_TRUE(journey.untilOutcome().succeeded) << i;
    slowest = std::min(slowest, journey.car.state().speed);
  }
  EXPECT_GT(slowest, 1.9);
  EXPECT_GT(journey.clearance, 0.4);
}

// What plans are content with where there is no more.
TEST(Navigator, movesAGoalAsideAlsoWhereThereIsLittleRoom)
{
  Journey journey(passingNavigator(), makeCostmap(drawRoom(14.0, 1.4)), {2.0, 0.7, 0.0});
  const auto onTheGoal = [](double angle) { return std::abs(angle) < 0.05 ? 3.0 : 9.5; };
  journey.costmap().observe(scanFrom(journey.car.state().pose, onTheGoal));
  const Pose2 goal{4.8, 0.7, 0.0};
  Goals goals;
  goals.set(goal, {});
  ASSERT_FALSE(goals.moveAside(journey.costmap(), passingNavigator().planner.min_obstacle_dist));
  journey.navigator.setGoal(goal, journey.time, {{10.0, 0.7, 0.0}});
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  EXPECT_TRUE(journey.recoveries.empty()) << "nothing has to be forgotten for it";
  EXPECT_GT(journey.clearance, 0.02);
}

TEST(Navigator, passesAGoalWhereTheMapHasACone)
{
  OccupancyGrid map = drawRoom(14.0, 3.0);
  const Pose2 goal{6.0, 1.5, 0.0};
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const bool cone = distance(map.geometry.centre(map.geometry.cell(i)), {6.4, 1.5}) < 0.1;
    map.cells[i] = cone ? 100 : map.cells[i];
  }
  Journey journey(passingNavigator(), makeCostmap(map), {2.0, 1.5, 0.0});
  journey.navigator.setGoal(goal, journey.time, {{11.0, 1.5, 0.0}});
  EXPECT_EQ(journey.untilOutcome().text, "Goal reached.");
  EXPECT_GT(journey.clearance, 0.02);
}

TEST(Navigator, stopsAtEachGoalWhenTheirSpeedIsNotFree)
{
  Journey journey(racingJourney(), makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(6.0), journey.time, {onOval(12.0)});
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  expectStandsAt(journey, onOval(6.0));
}

TEST(Navigator, comesToAStandBehindAPassedGoalWhoseNextOneDoesNotCome)
{
  Journey journey(passingNavigator(), makeCostmap(drawOval()), onOval(0.0));
  journey.navigator.setGoal(onOval(6.0), journey.time, {onOval(20.0)});
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  const Pose2 passed = journey.car.state().pose;
  for (int i = 0; i < 100 && journey.cycle().command; ++i) {
  }
  EXPECT_LT(std::abs(journey.car.state().speed), 0.05);
  EXPECT_EQ(journey.command.speed, 0.0);
  EXPECT_GT(distance(passed, journey.car.state().pose), 1.0);
  EXPECT_GT(journey.clearance, 0.4);
}

// The greatest speed, m/s, and whether race lines are driven.
class NavigatorAtSpeed : public ::testing::TestWithParam<std::tuple<double, bool>>
{
protected:
  NavigatorAtSpeed() : journey(options(), makeCostmap(drawRoom(60.0, 4.0)), {1.0, 2.0, 0.0}) {}

  static JourneyOptions options()
  {
    JourneyOptions options = passingNavigator();
    options.follower.limits.max_vel_x = std::get<0>(GetParam());
    options.follower.limits.acc_lim_x = options.follower.limits.dec_lim_x = 6.0;
    options.race_line = std::get<1>(GetParam());
    return options;
  }

  void driveAt(double x)
  {
    journey.navigator.setGoal({58.0, 2.0, 0.0}, journey.time);
    while (journey.car.state().pose.x < x) {
      journey.cycle();
    }
  }

  Journey journey;
};

TEST_P(NavigatorAtSpeed, standsAtALoneGoal)
{
  const Pose2 goal{25.0, 1.5, 0.1};
  journey.navigator.setGoal(goal, journey.time);
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  expectStandsAt(journey, goal);
}

TEST_P(NavigatorAtSpeed, standsAtTheLastGoalOfAQueue)
{
  const std::vector<Pose2> queue{{15.0, 2.0, 0.0}, {22.0, 1.6, 0.0}, {23.0, 1.6, 0.0}, {23.5, 1.6, 0.0}};
  for (auto goal = queue.begin(); goal != queue.end(); ++goal) {
    journey.navigator.setGoal(*goal, journey.time, {std::next(goal), queue.end()});
    ASSERT_TRUE(journey.untilOutcome().succeeded);
    EXPECT_LT(journey.car.state().pose.x, 23.7);
  }
  expectStandsAt(journey, queue.back());
}

TEST_P(NavigatorAtSpeed, comesBackToALoneGoalForWhichItIsTooFast)
{
  driveAt(20.0);
  const Pose2 goal{journey.car.state().pose.x + 0.5, 2.0, 0.0};
  journey.navigator.setGoal(goal, journey.time);
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  expectStandsAt(journey, goal);
}

TEST_P(NavigatorAtSpeed, stopsAtAGoalWhoseNextOnesAreDropped)
{
  const Pose2 goal{30.0, 2.0, 0.0};
  journey.navigator.setGoal(goal, journey.time, {{58.0, 2.0, 0.0}});
  while (journey.car.state().pose.x < 18.0) {
    journey.cycle();
  }
  journey.navigator.setNextGoals({});
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  expectStandsAt(journey, goal);
}

TEST_P(NavigatorAtSpeed, passesAGoalThatGetsANextOneOnTheWay)
{
  const double speed = std::get<0>(GetParam());
  journey.navigator.setGoal({20.0, 2.0, 0.0}, journey.time);
  journey.cycle();
  journey.navigator.setNextGoals({{58.0, 2.0, 0.0}});
  ASSERT_TRUE(journey.untilOutcome().succeeded);
  EXPECT_GT(journey.car.state().speed, 0.8 * speed);
  EXPECT_FALSE(journey.navigator.active());
  EXPECT_TRUE(journey.navigator.drives()) << "until the next goal comes, or it stands";
}

INSTANTIATE_TEST_SUITE_P(
  EverySpeed, NavigatorAtSpeed, ::testing::Combine(::testing::Values(0.5, 1.0, 2.0, 4.0, 6.0, 8.0), ::testing::Bool()));
}  // namespace
}  // namespace f1tenth_racer
