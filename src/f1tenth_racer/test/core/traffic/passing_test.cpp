#include "traffic/passing.h"

#include <gtest/gtest.h>

#include "roads.h"
#include "traffic/traffic.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawRoom;
using testing::makeCostmap;

constexpr double kSpeed = 2.0;  // m/s, of the car

/// A straight road along x, that the car drives on with its rear axle at x = 5.
class PlanPast : public ::testing::Test
{
protected:
  static constexpr double kX = 5.0;

  /// @param width  m, of the road
  /// @param pose   where the other is from the rear axle of the car
  std::optional<PassingPlan> past(double width, const Pose2 & pose, double speed)
  {
    costmap_ = makeCostmap(drawRoom(40.0, width + 0.2));
    const double middle = 0.5 * width + 0.1;
    plan_.path = samplePath({kX, middle, 0.0}, {{25.0, 0.0}}, 0.1);
    plan_.goal_s = goal_s_;
    PlanRequest request{{}, {kX + plan_.goal_s, middle, 0.0}};
    request.race_line = RaceLineOptions{0.3, 0.4, 0.0, limits_.max_lateral_acceleration, limits_.max_vel_x, next_};
    request.lead.assign(plan_.path.begin(), plan_.path.begin() + 4);
    request.start = request.lead.back().pose;
    const Pose2 there{kX + pose.x, middle + pose.y, pose.yaw};
    others_ = {Forecast({{there, 0.29, 0.155}, speed, 0.0}, costmap_, 0.0)};
    return planPast({costmap_, {}, limits_, plan_, request, others_, 0.0, {{kX, middle, 0.0}, kSpeed}});
  }

  /// Whether the car, driving as the plan says, comes near the other.
  bool touches(const PassingPlan & past) const
  {
    const std::vector<double> speeds = speedProfile(past.plan.path, costmap_, limits_, past.caution);
    const auto drive = driveAlong(past.plan.path, speeds, {0.0, 0.0, kSpeed}, limits_, kForecastTime);
    return firstTouch(drive, costmap_.footprint(), others_.front(), 0.05).has_value();
  }

  /// How far the path leads to the left of the straight line at most, m; negative to the right.
  double aside(const PassingPlan & past) const
  {
    double farthest = 0.0;
    for (const PathPoint & point : past.plan.path) {
      const double y = point.pose.y - past.plan.path.front().pose.y;
      farthest = std::abs(y) > std::abs(farthest) ? y : farthest;
    }
    return farthest;
  }

  SpeedLimits limits_{racing()};
  Costmap costmap_{makeCostmap(drawRoom(4.0, 4.0))};
  Plan plan_{SearchStatus::kFound, {}, 0.0, 0};
  double goal_s_{24.0};      ///< m, where the goal is on the plan
  std::vector<Pose2> next_;  ///< goals beyond it
  std::vector<Forecast> others_;

private:
  static SpeedLimits racing()
  {
    SpeedLimits limits;
    limits.max_vel_x = 4.0;
    limits.max_vel_theta = 8.0;
    limits.acc_lim_x = limits.dec_lim_x = 6.0;
    return limits;
  }
};

TEST_F(PlanPast, leadsPastWhoIsSlowerOnTheFreeSide)
{
  for (const double y : {0.3, -0.3}) {
    const auto found = past(2.4, {3.0, y, 0.0}, 1.0);
    ASSERT_TRUE(found) << y;
    EXPECT_FALSE(std::isfinite(found->caution.pace));
    EXPECT_LT(found->caution.lateral_part, 1.0);
    EXPECT_LT(aside(*found) * y, 0.0);
    EXPECT_FALSE(touches(*found));
    EXPECT_NEAR(found->plan.goal_s, plan_.goal_s, 0.5);
  }
}

TEST_F(PlanPast, passesTheGoalsBeyondWithinTheirTolerance)
{
  goal_s_ = 1.0;
  const Pose2 other{3.0, 0.0, 0.0};
  const auto free = past(2.4, other, 1.0);
  ASSERT_TRUE(free);
  const double y = free->plan.path.front().pose.y;
  const auto aside = [y](const PassingPlan & found, const Pose2 & goal) {
    return std::abs(found.plan.path[nearestTo(found.plan.path, goal)].pose.y - y);
  };
  const Pose2 behind{kX + 6.5, y, 0.0};
  ASSERT_GT(aside(*free, behind), 0.32);
  next_ = {behind};
  const auto found = past(2.4, other, 1.0);
  ASSERT_TRUE(found);
  EXPECT_LT(aside(*found, behind), 0.305);
  EXPECT_FALSE(touches(*found));

  const Pose2 beside{kX + 5.2, y, 0.0};
  ASSERT_GT(aside(*free, beside), 0.4);
  next_ = {beside};
  const auto slow = past(2.4, other, 1.0);
  EXPECT_TRUE(!slow || std::isfinite(slow->caution.pace));
}

TEST_F(PlanPast, swingsOutAtThePaceOfWhoIsCloseAhead)
{
  const auto found = past(2.4, {1.1, 0.0, 0.0}, 1.8);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->caution.pace, 1.8, 0.1);
  EXPECT_LT(found->caution.until, 3.0);
  EXPECT_FALSE(touches(*found));
}

TEST_F(PlanPast, goesOnBesideWhoIsNextToIt)
{
  const auto found = past(2.4, {0.3, 0.5, 0.0}, 1.8);
  ASSERT_TRUE(found);
  EXPECT_FALSE(std::isfinite(found->caution.pace));
  EXPECT_FALSE(touches(*found));
}

TEST_F(PlanPast, fallsBehindWhoLeavesNoRoomBesideIt)
{
  const auto found = past(2.4, {0.6, 0.42, -0.15}, 3.5);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->caution.pace, 2.5, 0.1);
  EXPECT_FALSE(touches(*found));
}

TEST_F(PlanPast, findsNoWayWhereTheRoadIsTooNarrow)
{
  EXPECT_FALSE(past(0.9, {2.0, 0.0, 0.0}, 1.0));
}
}  // namespace
}  // namespace f1tenth_racer
