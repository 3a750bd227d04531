#include "planning/plan_near.h"

#include <gtest/gtest.h>

#include "move_base/planning/way_planner.h"
#include "rooms.h"

namespace move_base
{
namespace
{
using testing::drawMap;
using testing::drawRoom;
using testing::inRectangle;
using testing::makeCostmap;

TEST(PlanNear, endsAtTheGoalWhereOneLeadsThere)
{
  const Plan plan = planNear(WayPlanner{{}}, makeCostmap(drawRoom(8.0, 4.0)), {{1.0, 2.0, 0.0}, {6.0, 2.0, 0.0}}, 1.0);
  ASSERT_TRUE(plan.found());
  EXPECT_NEAR(distance(plan.path.back().pose, Pose2{6.0, 2.0, 0.0}), 0.0, 1e-6);
}

TEST(PlanNear, endsBesideAGoalInAWallWithinTheTolerance)
{
  const Costmap costmap = makeCostmap(drawMap(8.0, 4.0, [](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {7.9, 3.9}) || inRectangle(p, {5.8, 1.8}, {6.2, 2.2});
  }));
  PlanRequest request{{1.0, 2.0, 0.0}, {6.0, 2.0, 0.0}};
  request.max_expansions = 150000;
  EXPECT_FALSE(planNear(WayPlanner{{}}, costmap, request, 0.0).found());
  EXPECT_FALSE(planNear(WayPlanner{{}}, costmap, request, 0.2).found());
  const Plan plan = planNear(WayPlanner{{}}, costmap, request, 1.0);
  ASSERT_TRUE(plan.found());
  const Pose2 end = plan.path.back().pose;
  EXPECT_GE(costmap.clearance(end), 0.0);
  EXPECT_LE(std::max(std::abs(end.x - 6.0), std::abs(end.y - 2.0)), 1.0 + 1e-6);
  EXPECT_GT(distance(end, request.goal), 0.2);
}

TEST(PlanNear, spendsTheExpansionsOfOnePlan)
{
  const Costmap costmap = makeCostmap(drawMap(8.0, 4.0, [](const Vec2 & p) {
    return !inRectangle(p, {0.1, 0.1}, {7.9, 3.9}) || (std::abs(p.x - 4.0) < 0.1 && std::abs(p.y - 2.0) > 0.13);
  }));
  PlannerOptions options;
  options.max_expansions = 2000;
  PlanRequest request{{1.0, 2.0, 0.0}, {6.0, 2.0, 0.0}};
  request.max_expansions = options.max_expansions;
  const Plan plan = planNear(WayPlanner(options), costmap, request, 1.0);
  EXPECT_FALSE(plan.found());
  EXPECT_LE(plan.expansions, 2010);
}
}  // namespace
}  // namespace move_base
