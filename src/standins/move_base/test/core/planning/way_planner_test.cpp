#include "move_base/planning/way_planner.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include "expect_throws.h"
#include "rooms.h"

namespace move_base
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

// Three points of a path that was rounded give a curvature this much off.
constexpr double kCurvatureTolerance = 1.02;

PlannerOptions forwardOnly()
{
  PlannerOptions options;
  options.allow_reversing = false;
  return options;
}

Plan planOn(const Costmap & costmap, const PlannerOptions & options, const PlanRequest & request)
{
  return WayPlanner(options).makePlan(costmap, request);
}

void expectDrivable(const Plan & plan, const Costmap & costmap, const PlannerOptions & options)
{
  ASSERT_TRUE(plan.found()) << describe(plan.status);
  for (std::size_t i = 0; i < plan.path.size(); ++i) {
    const PathPoint & point = plan.path[i];
    EXPECT_LE(std::abs(point.curvature), kCurvatureTolerance / options.min_turning_radius) << i;
    EXPECT_GE(costmap.clearance(point.pose), 0.0) << i;
    if (i > 0) {
      const PathPoint & before = plan.path[i - 1];
      EXPECT_NEAR(point.s - before.s, distance(before.pose, point.pose), 0.005) << i;
      EXPECT_LE(point.s - before.s, 0.15) << i;
      const Vec2 along = transform({0.0, 0.0, -before.pose.yaw}, point.pose.position() - before.pose.position());
      EXPECT_LE(std::abs(along.y), 0.01) << "sideways at " << i;
    }
  }
}

void expectReaches(const Plan & plan, const Pose2 & goal)
{
  ASSERT_TRUE(plan.found());
  EXPECT_NEAR(plan.path.back().pose.x, goal.x, 1e-3);
  EXPECT_NEAR(plan.path.back().pose.y, goal.y, 1e-3);
  EXPECT_NEAR(normalizeAngle(plan.path.back().pose.yaw - goal.yaw), 0.0, 1e-3);
}

TEST(WayPlanner, drivesAStraightCorridorStraight)
{
  const Costmap costmap = makeCostmap(drawRoom(10.0, 1.6));
  const Plan plan = planOn(costmap, forwardOnly(), {{1.0, 0.8, 0.0}, {8.0, 0.8, 0.0}});
  expectDrivable(plan, costmap, forwardOnly());
  expectReaches(plan, {8.0, 0.8, 0.0});
  EXPECT_NEAR(length(plan.path), 7.0, 0.05);
}

TEST(WayPlanner, keepsToTheMiddleOfACorridor)
{
  const Costmap costmap = makeCostmap(drawRoom(12.0, 1.6));
  const Plan plan = planOn(costmap, forwardOnly(), {{1.0, 0.5, 0.0}, {10.0, 0.5, 0.0}});
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_NEAR(plan.path[plan.path.size() / 2].pose.y, 0.8, 0.06);
}

TEST(WayPlanner, takesAHairpinWithinTheTurningRadius)
{
  const Costmap costmap = makeCostmap(drawHairpin());
  const Plan plan = planOn(costmap, forwardOnly(), {{1.0, 0.8, 0.0}, {1.0, 2.8, M_PI}});
  expectDrivable(plan, costmap, forwardOnly());
  expectReaches(plan, {1.0, 2.8, M_PI});
}

TEST(WayPlanner, goesAllAroundWhenTheGoalIsBehindAndItMayNotReverse)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan plan = planOn(costmap, forwardOnly(), {onOval(4.0), onOval(2.0)});
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_GT(length(plan.path), 30.0);
}

TEST(WayPlanner, reversesWhenTheGoalIsBehindAndItMay)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan plan = planOn(costmap, {}, {onOval(4.0), onOval(2.0)});
  expectDrivable(plan, costmap, {});
  expectReaches(plan, onOval(2.0));
  EXPECT_LT(length(plan.path), 3.0);
  EXPECT_TRUE(plan.path.front().reverse);
}

TEST(WayPlanner, turnsInThreePointsWhereTheRoadIsNarrow)
{
  const Costmap costmap = makeCostmap(drawRoom(8.0, 1.8));
  const Plan plan = planOn(costmap, {}, {{3.0, 0.9, 0.0}, {3.0, 0.9, M_PI}});
  expectDrivable(plan, costmap, {});
  expectReaches(plan, {3.0, 0.9, M_PI});
  EXPECT_GE(stretches(plan.path).size(), 3U);
}

TEST(WayPlanner, findsNoWayOutOfADeadEndWithoutReversing)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 1.4));
  const Plan plan = planOn(costmap, forwardOnly(), {{4.0, 0.7, 0.0}, {1.0, 0.7, 0.0}});
  EXPECT_EQ(plan.status, SearchStatus::kUnreachable);
  EXPECT_TRUE(plan.path.empty());
}

TEST(WayPlanner, saysAtOnceThatAGoalBehindAWallIsUnreachable)
{
  const Costmap costmap =
    makeCostmap(drawMap(8.0, 4.0, [](const Vec2 & p) { return std::abs(p.x - 4.0) < 0.1 || p.y < 0.1 || p.y > 3.9; }));
  const Plan plan = planOn(costmap, {}, {{2.0, 2.0, 0.0}, {6.0, 2.0, 0.0}});
  EXPECT_EQ(plan.status, SearchStatus::kUnreachable);
  EXPECT_EQ(plan.expansions, 0);
}

TEST(WayPlanner, refusesAGoalInAWallOrOutsideOfTheMap)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  EXPECT_EQ(planOn(costmap, {}, {{2.0, 2.0, 0.0}, {5.9, 2.0, 0.0}}).status, SearchStatus::kGoalBlocked);
  EXPECT_EQ(planOn(costmap, {}, {{2.0, 2.0, 0.0}, {60.0, 2.0, 0.0}}).status, SearchStatus::kGoalBlocked);
}

TEST(WayPlanner, refusesAStartInAWall)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  EXPECT_EQ(planOn(costmap, {}, {{5.6, 2.0, 0.0}, {2.0, 2.0, 0.0}}).status, SearchStatus::kStartBlocked);
}

TEST(WayPlanner, leavesAPlaceCloserToAWallThanItWouldGo)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 4.0));
  const Pose2 start{2.0, 0.32, 0.0};
  ASSERT_LT(costmap.clearance(start), PlannerOptions{}.min_obstacle_dist);
  const Plan plan = planOn(costmap, forwardOnly(), {start, {5.0, 2.0, 0.0}});
  expectDrivable(plan, costmap, forwardOnly());
}

TEST(WayPlanner, passesAGapThatIsNarrowerThanWanted)
{
  const Costmap costmap = makeCostmap(drawMap(8.0, 3.0, [](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {7.9, 2.9}) || (std::abs(p.x - 4.0) < 0.2 && std::abs(p.y - 1.5) > 0.25);
  }));
  const Plan plan = planOn(costmap, forwardOnly(), {{1.0, 1.5, 0.0}, {7.0, 1.5, 0.0}});
  expectDrivable(plan, costmap, forwardOnly());
}

// A hall with a divider, and a closet behind a gap of the given width.
OccupancyGrid drawCloset(double gap)
{
  return drawMap(12.0, 6.0, [=](const Vec2 & p) {
    const bool divider = inRectangle(p, {4.0, 0.0}, {4.2, 3.5});
    const bool closet_wall = inRectangle(p, {9.0, 0.0}, {9.2, 2.2}) && std::abs(p.y - 1.0) > 0.5 * gap;
    const bool closet_top = inRectangle(p, {9.0, 2.0}, {12.0, 2.2});
    return !inRectangle(p, {0.1, 0.1}, {11.9, 5.9}) || divider || closet_wall || closet_top;
  });
}

TEST(WayPlanner, findsTheNarrowDoorOfAClosetWithinItsBudget)
{
  for (const double gap : {0.5, 0.6, 0.8}) {
    const Costmap costmap = makeCostmap(drawCloset(gap));
    const Plan plan = planOn(costmap, {}, {{1.0, 1.0, 0.0}, {10.5, 1.0, 0.0}});
    expectDrivable(plan, costmap, {});
    EXPECT_LT(plan.expansions, 70000) << gap;
  }
}

TEST(WayPlanner, goesOnBeyondTheGoalWhenAsked)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan plan = planOn(costmap, forwardOnly(), {onOval(1.0), onOval(6.0), 0.0, 4.0});
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_NEAR(plan.goal_s, 5.0, 0.2);
  EXPECT_GE(length(plan.path), 8.8);
}

TEST(WayPlanner, goesOnAsItIsLed)
{
  const Costmap costmap = makeCostmap(drawOval());
  for (const double aside : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
    for (const double way : {2.0, 2.5, 3.0, 3.5, 4.0}) {
      PlanRequest request{onOval(9.0), onOval(10.0 + way)};
      const double bend = 1.0 / (3.0 - aside);
      const Pose2 begin = compose(onOval(9.0), {0.0, aside, 0.0});
      for (double s = 0.0; s < 1.05; s += 0.1) {
        request.lead.push_back({advance(begin, s, bend), bend, false, s});
      }
      request.start = request.lead.back().pose;
      request.start_curvature = bend;
      const Plan plan = planOn(costmap, forwardOnly(), request);
      ASSERT_TRUE(plan.found());
      const auto turn = [&](std::size_t i) {
        return normalizeAngle(plan.path[i + 1].pose.yaw - plan.path[i].pose.yaw);
      };
      for (std::size_t i = request.lead.size() - 2; i <= request.lead.size(); ++i) {
        EXPECT_NEAR(turn(i), 0.5 * (turn(i - 1) + turn(i + 1)), 0.015) << aside << ", " << way << ", " << i;
      }
    }
  }
}

TEST(WayPlanner, endsAtTheGoalWhereTheRoadEnds)
{
  const Costmap costmap = makeCostmap(drawRoom(6.0, 1.4));
  const Plan plan = planOn(costmap, forwardOnly(), {{1.0, 0.7, 0.0}, {4.5, 0.7, 0.0}, 0.0, 4.0});
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_LT(length(plan.path), 5.0);
}

// Something stands on the road so near behind the goal that a car at the goal gets past it no more.
Costmap closeBehindTheGoal(double width, double low, double high)
{
  return makeCostmap(drawMap(14.0, width, [=](const Vec2 & p) {
    const bool obstacle = inRectangle(p, {5.6, low}, {6.2, high});
    return !inRectangle(p, {0.1, 0.1}, {13.9, width - 0.1}) || obstacle;
  }));
}

PlanRequest racingPast(const Pose2 & goal, const std::vector<Pose2> & next)
{
  PlanRequest request{{1.0, goal.y, 0.0}, goal, 0.0, 8.0};
  RaceLineOptions gate;
  gate.gate_tolerance = 0.5;
  gate.gate_yaw_tolerance = 0.6;
  gate.lateral_acceleration = 5.0;
  gate.max_speed = 4.0;
  gate.goals_beyond = next;
  request.race_line = gate;
  return request;
}

TEST(WayPlanner, passesAGoalOnTheWayToTheNextOneWhereItCannotRollOn)
{
  const Costmap costmap = closeBehindTheGoal(2.0, 0.85, 1.15);
  const Pose2 goal{4.9, 1.0, 0.0};
  EXPECT_LT(length(planOn(costmap, forwardOnly(), racingPast(goal, {})).path), 5.0);
  const Plan plan = planOn(costmap, forwardOnly(), racingPast(goal, {{9.0, 1.0, 0.0}}));
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_GT(length(plan.path), 8.0);
  EXPECT_LE(distance(plan.path[nearestTo(plan.path, goal)].pose, goal), 0.51);
}

TEST(WayPlanner, goesOnWithLessClearanceWhereThatLeadsFarther)
{
  const Costmap costmap = closeBehindTheGoal(2.6, 0.6, 2.5);
  const Pose2 goal{4.0, 1.1, 0.0};
  const Plan plan = planOn(costmap, forwardOnly(), racingPast(goal, {{9.0, 1.3, 0.0}}));
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_GT(length(plan.path), 8.0);
}

TEST(WayPlanner, givesTheSamePlanAgain)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan one = planOn(costmap, {}, {onOval(0.0), onOval(17.0)});
  const Plan two = planOn(costmap, {}, {onOval(0.0), onOval(17.0)});
  ASSERT_EQ(one.path.size(), two.path.size());
  for (std::size_t i = 0; i < one.path.size(); ++i) {
    EXPECT_EQ(one.path[i].pose.x, two.path[i].pose.x);
    EXPECT_EQ(one.path[i].pose.yaw, two.path[i].pose.yaw);
  }
}

TEST(WayPlanner, givesUpWhenItsBudgetIsSpent)
{
  PlannerOptions options = forwardOnly();
  options.max_expansions = 10;
  const Costmap costmap = makeCostmap(drawOval());
  EXPECT_EQ(planOn(costmap, options, {onOval(4.0), onOval(2.0)}).status, SearchStatus::kBudgetSpent);
}

TEST(PlannerOptions, takeARadiusThatIsExactlyTheLeast)
{
  for (int wheelbase = 20; wheelbase <= 40; ++wheelbase) {
    for (int part = 11; part <= 40; ++part) {
      PlannerOptions options;
      options.min_turning_radius = 0.001 * wheelbase * part;
      const double angle = maths::atan(0.01 * wheelbase / options.min_turning_radius);
      EXPECT_NO_THROW(options.requireSteering(0.01 * wheelbase, angle)) << wheelbase << ", " << part;
      EXPECT_THROW(options.requireSteering(0.01 * wheelbase, 0.99 * angle), OptionError);
    }
  }
}

TEST(PlannerOptions, areChecked)
{
  PlannerOptions options;
  options.min_turning_radius = 0.0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "min_turning_radius: found 0, must be a number above 0");
  options = {};
  options.reverse_penalty = 0.5;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "reverse_penalty: found 0.5, must be at least 1");
  options = {};
  options.max_expansions = 0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "max_expansions: found 0, must be above 0");
}
}  // namespace
}  // namespace move_base
