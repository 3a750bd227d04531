#include "line/race_line.h"

#include <gtest/gtest.h>

#include "line/race_line_planner.h"
#include "roads.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawHairpin;
using testing::drawMap;
using testing::drawOval;
using testing::drawRoom;
using testing::inRectangle;
using testing::makeCostmap;
using testing::onOval;

constexpr double kGreatestCurvature = 1.25;  // 1/m
const RaceLineOptions kRacing{0.3, 0.4, 0.0178, 7.0, 8.0};

Plan planOn(
  const Costmap & costmap, const Pose2 & start, const Pose2 & goal, std::optional<RaceLineOptions> racing,
  double wheels = 0.0)
{
  PlanRequest request{start, goal, wheels};
  request.extension_length = 6.0;
  request.race_line = racing;
  return RaceLinePlanner(PlannerOptions{}).makePlan(costmap, request);
}

double greatestCurvature(const Path & path)
{
  double greatest = 0.0;
  for (const PathPoint & point : path) {
    greatest = std::max(greatest, std::abs(point.curvature));
  }
  return greatest;
}

double leastClearance(const Path & path, const Costmap & costmap)
{
  double least = HUGE_VAL;
  for (const PathPoint & point : path) {
    least = std::min(least, costmap.clearance(point.pose));
  }
  return least;
}

double bendingOf(const Path & path)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    sum += path[i].curvature * path[i].curvature * (path[i].s - path[i - 1].s);
  }
  return sum;
}

TEST(RaceLine, makesBendsWiderThanTheMiddleOfTheRoadDoes)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan middle = planOn(costmap, onOval(2.0), onOval(19.0), std::nullopt);
  const Plan race = planOn(costmap, onOval(2.0), onOval(19.0), kRacing);
  ASSERT_TRUE(race.found());
  EXPECT_LT(bendingOf(race.path), 0.95 * bendingOf(middle.path));
  EXPECT_GT(leastClearance(race.path, costmap), 0.085);
}

TEST(RaceLine, passesTheGoalWithinTheTolerance)
{
  const Costmap costmap = makeCostmap(drawOval());
  for (const double goal : {8.0, 11.0, 14.0}) {
    const Plan race = planOn(costmap, onOval(2.0), onOval(goal), kRacing);
    double nearest = HUGE_VAL;
    for (const PathPoint & point : race.path) {
      nearest = std::min(nearest, distance(point.pose, onOval(goal)));
    }
    EXPECT_LT(nearest, 0.31) << goal;
    EXPECT_LT(distance(race.path.front().pose, onOval(2.0)), 1e-3);
  }
}

// A chicane in a hall: who takes the way of least curvature passes its middle straight on.
TEST(RaceLine, passesTheGoalWithItsHeadingOnAWideRoad)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 8.0));
  for (const double yaw : {-1.0, -0.7, 0.7, 1.0}) {
    const Pose2 goal{6.0, 4.0, yaw};
    const Plan race = planOn(costmap, {1.0, 4.0, 0.0}, goal, kRacing);
    ASSERT_TRUE(race.found());
    const auto at =
      std::find_if(race.path.begin(), race.path.end(), [&](const PathPoint & point) { return point.s >= race.goal_s; });
    ASSERT_NE(at, race.path.end());
    EXPECT_LT(distance(at->pose, goal), 0.4) << yaw;
    EXPECT_LT(std::abs(at->pose.yaw - yaw), 0.5) << yaw;
  }
}

RaceLineOptions racingWith(const std::vector<Pose2> & goals_beyond)
{
  RaceLineOptions options = kRacing;
  options.goals_beyond = goals_beyond;
  return options;
}

TEST(RaceLine, passesTheGoalsBeyondAsNear)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 8.0));
  const Pose2 beyond{8.0, 4.6, 0.7};
  const Plan race = planOn(costmap, {1.0, 4.0, 0.0}, {4.0, 4.0, 0.0}, racingWith({beyond}));
  ASSERT_TRUE(race.found());
  const Pose2 there = race.path[nearestTo(race.path, beyond)].pose;
  EXPECT_LT(distance(there, beyond), 0.32);
  EXPECT_LT(std::abs(there.yaw - beyond.yaw), 0.5);
}

// A lane that comes back: its goals are beside this one.
TEST(RaceLine, keepsToTheOrderOfTheGoalsBeyond)
{
  const Costmap costmap = makeCostmap(drawRoom(16.0, 4.0));
  const Pose2 far{14.9, 2.0, 0.0};
  const Plan race = planOn(costmap, {1.0, 2.0, 0.0}, {4.0, 2.0, 0.0}, racingWith({far, {8.0, 2.8, M_PI}}));
  ASSERT_TRUE(race.found());
  for (const PathPoint & point : race.path) {
    EXPECT_NEAR(point.pose.y, 2.0, 0.05) << point.s;
  }
}

// Who plans anew at each goal must not turn away from the line on which it came.
TEST(RaceLine, goesOnAsThePlanBeforeWhichKnewTheSameGoals)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Path before = planOn(costmap, onOval(3.0), onOval(7.0), racingWith({onOval(11.0), onOval(15.0)})).path;
  const PathPoint & here = before[firstBeyond(before, 3.0)];
  const Plan now = planOn(costmap, here.pose, onOval(11.0), racingWith({onOval(15.0)}), here.curvature);
  ASSERT_TRUE(now.found());
  for (const PathPoint & point : now.path) {
    if (point.s < 5.0) {
      const PathPoint & then = before[nearestTo(before, point.pose)];
      EXPECT_LT(distance(point.pose, then.pose), 0.1) << point.s;
      EXPECT_NEAR(point.curvature, then.curvature, 0.15) << point.s;
    }
  }
}

TEST(RaceLine, isNotSpoiltByAGoalBeyondThatItCannotPass)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Pose2 across = compose(onOval(16.0), {0.0, 0.0, 1.5});
  const Path free = planOn(costmap, onOval(2.0), onOval(12.0), kRacing).path;
  const Path held = planOn(costmap, onOval(2.0), onOval(12.0), racingWith({across})).path;
  ASSERT_FALSE(held.empty());
  EXPECT_LT(bendingOf(held), 1.05 * bendingOf(free));
}

TEST(RaceLine, startsWithTheCurvatureOfTheWheels)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan plan = planOn(costmap, onOval(9.0), onOval(15.0), kRacing, 0.4);
  ASSERT_TRUE(plan.found());
  EXPECT_NEAR(plan.path[1].curvature, 0.4, 0.02);
}

// A car in a tight bend has its wheels at their stop, a little farther than plans turn them, and the way goes on to the other side.
TEST(RaceLine, leavesABendInWhichTheWheelsAreAtTheirStop)
{
  const Costmap costmap = makeCostmap(drawOval());
  for (const double wheels : {1.34, -1.34}) {
    for (const double aside : {-0.6, -0.4, 0.4, 0.6}) {
      const Plan plan = planOn(costmap, compose(onOval(9.0), {0.0, 0.0, aside}), onOval(15.0), kRacing, wheels);
      ASSERT_TRUE(plan.found());
      EXPECT_LT(greatestCurvature(plan.path), 1.03 * std::abs(wheels)) << wheels << " " << aside;
    }
  }
}

TEST(RaceLine, keepsTheTurningRadiusInAHairpin)
{
  const Costmap costmap = makeCostmap(drawHairpin());
  const Plan race = planOn(costmap, {2.0, 0.8, 0.0}, {4.0, 2.8, M_PI}, kRacing);
  ASSERT_TRUE(race.found());
  EXPECT_LT(greatestCurvature(race.path), 1.05 * kGreatestCurvature);
  EXPECT_GT(leastClearance(race.path, costmap), 0.0);
}

TEST(RaceLine, staysOnItsSideOfAnObstacle)
{
  const OccupancyGrid pillar = drawMap(12.0, 3.0, [](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {11.9, 2.9}) || inRectangle(p, {5.8, 1.2}, {6.2, 1.5});
  });
  const Costmap costmap = makeCostmap(pillar);
  const Plan race = planOn(costmap, {1.0, 1.4, 0.0}, {10.0, 1.4, 0.0}, kRacing);
  ASSERT_TRUE(race.found());
  EXPECT_GT(leastClearance(race.path, costmap), 0.085);
}

// Who is headed to one side of what stands in the way turns to the other side gently, not with the wheels at their stop.
TEST(RaceLine, isNotGivenUpWhereTheWayIsNarrow)
{
  for (const double gap : {0.56, 0.58, 0.60, 0.62, 0.64}) {
    const OccupancyGrid road = drawMap(16.0, 2.0, [=](const Vec2 & p) {
      return !inRectangle(p, {0.1, 0.1}, {15.9, 1.9}) || inRectangle(p, {6.0, 0.1}, {6.4, 1.9 - gap});
    });
    const Costmap costmap = makeCostmap(road);
    PlanRequest request{{2.0, 1.0, -0.08}, {4.0, 1.0, 0.0}, -0.09};
    request.extension_length = 8.0;
    request.race_line = kRacing;
    const Plan plan = RaceLinePlanner(PlannerOptions{}).makePlan(costmap, request);
    ASSERT_TRUE(plan.found()) << gap;
    EXPECT_NEAR(plan.path[1].curvature, -0.09, 0.02) << gap;
    EXPECT_LT(greatestCurvature(plan.path), 0.8) << gap;
    EXPECT_GT(leastClearance(plan.path, costmap), 0.06) << gap;
  }
}

TEST(RaceLine, keepsItsDistanceWhereThereIsRoomOnAWayThroughAGap)
{
  const auto drawRoad = [](double gap) {
    return drawMap(12.0, 9.0, [=](const Vec2 & p) {
      const bool along = inRectangle(p, {0.2, 1.0}, {7.0, 2.6});
      const bool up = inRectangle(p, {5.4, 1.0}, {7.0, 8.8});
      const bool before_gap = inRectangle(p, {5.4, 6.0}, {7.0 - gap, 6.3});
      return !(along || up) || before_gap;
    });
  };
  for (const double gap : {0.45, 0.9}) {
    const Costmap costmap = makeCostmap(drawRoad(gap));
    const Plan plan = planOn(costmap, {1.0, 1.8, 0.0}, {6.7, 7.8, 0.5 * M_PI}, kRacing);
    ASSERT_TRUE(plan.found()) << gap;
    double least = HUGE_VAL;
    for (const PathPoint & point : plan.path) {
      least = point.pose.y < 4.5 ? std::min(least, costmap.clearance(point.pose)) : least;
    }
    EXPECT_GT(least, 0.085) << gap;
  }
}

TEST(RaceLine, isTheSameEveryTime)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Path first = planOn(costmap, onOval(2.0), onOval(14.0), kRacing).path;
  const Path second = planOn(costmap, onOval(2.0), onOval(14.0), kRacing).path;
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].pose.x, second[i].pose.x);
    ASSERT_EQ(first[i].pose.y, second[i].pose.y);
  }
}

TEST(RaceLine, isNotWantedOfAPathThatReverses)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  const Plan race = planOn(costmap, {3.0, 2.0, 0.0}, {1.5, 2.0, 0.0}, kRacing);
  ASSERT_TRUE(race.found());
  EXPECT_LT(distance(race.path.front().pose, {3.0, 2.0, 0.0}), 1e-9);
}

TEST(Lead, staysAsItIsBeforeANewPlan)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Path before = planOn(costmap, onOval(2.0), onOval(8.0), kRacing).path;
  PlanRequest request;
  request.lead = Path(before.begin() + 10, before.begin() + 20);
  request.start = request.lead.back().pose;
  request.start_curvature = request.lead.back().curvature;
  request.goal = onOval(14.0);
  request.race_line = kRacing;
  const Plan plan = RaceLinePlanner(PlannerOptions{}).makePlan(costmap, request);
  ASSERT_TRUE(plan.found());
  EXPECT_NEAR(plan.path[4].pose.x, before[14].pose.x, 1e-12);
  EXPECT_NEAR(plan.path.front().s, 0.0, 1e-12);
  for (std::size_t i = 1; i < plan.path.size(); ++i) {
    ASSERT_GT(plan.path[i].s, plan.path[i - 1].s) << i;
  }
  EXPECT_LT(distance(plan.path.back().pose, onOval(14.0)), 0.31);
}
}  // namespace
}  // namespace f1tenth_racer
