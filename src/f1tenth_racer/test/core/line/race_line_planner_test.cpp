#include "line/race_line_planner.h"

#include <drivable.h>
#include <gtest/gtest.h>

#include "roads.h"

namespace f1tenth_racer
{
namespace
{
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
  return RaceLinePlanner(options).makePlan(costmap, request);
}

TEST(RaceLinePlanner, goesOnBeyondTheGoalWhenAsked)
{
  const Costmap costmap = makeCostmap(drawOval());
  const Plan plan = planOn(costmap, forwardOnly(), {onOval(1.0), onOval(6.0), 0.0, 4.0});
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_NEAR(plan.goal_s, 5.0, 0.2);
  EXPECT_GE(length(plan.path), 8.8);
}

TEST(RaceLinePlanner, goesOnAsItIsLed)
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

TEST(RaceLinePlanner, endsAtTheGoalWhereTheRoadEnds)
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

TEST(RaceLinePlanner, passesAGoalOnTheWayToTheNextOneWhereItCannotRollOn)
{
  const Costmap costmap = closeBehindTheGoal(2.0, 0.85, 1.15);
  const Pose2 goal{4.9, 1.0, 0.0};
  EXPECT_LT(length(planOn(costmap, forwardOnly(), racingPast(goal, {})).path), 5.0);
  const Plan plan = planOn(costmap, forwardOnly(), racingPast(goal, {{9.0, 1.0, 0.0}}));
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_GT(length(plan.path), 8.0);
  EXPECT_LE(distance(plan.path[nearestTo(plan.path, goal)].pose, goal), 0.51);
}

TEST(RaceLinePlanner, goesOnWithLessClearanceWhereThatLeadsFarther)
{
  const Costmap costmap = closeBehindTheGoal(2.6, 0.6, 2.5);
  const Pose2 goal{4.0, 1.1, 0.0};
  const Plan plan = planOn(costmap, forwardOnly(), racingPast(goal, {{9.0, 1.3, 0.0}}));
  expectDrivable(plan, costmap, forwardOnly());
  EXPECT_GT(length(plan.path), 8.0);
}
}  // namespace
}  // namespace f1tenth_racer
