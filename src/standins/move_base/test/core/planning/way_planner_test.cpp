#include "move_base/planning/way_planner.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include "drivable.h"
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
using testing::expectDrivable;
using testing::forwardOnly;
using testing::inRectangle;
using testing::makeCostmap;
using testing::onOval;

Plan planOn(const Costmap & costmap, const PlannerOptions & options, const PlanRequest & request)
{
  return WayPlanner(options).makePlan(costmap, request);
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
  EXPECT_NEAR(plan.path[plan.path.size() / 2].pose.y, 0.8, 0.1);
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
  options.max_expansions = 0;
  EXPECT_THROWS_MESSAGE(options.validate(), OptionError, "max_expansions: found 0, must be above 0");
}
}  // namespace
}  // namespace move_base
