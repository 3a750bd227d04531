#include "speed/speed_profile.h"

#include <gtest/gtest.h>
#include <workspace_support/errors.h>

#include "expect_throws.h"
#include "roads.h"

namespace f1tenth_racer
{
namespace
{
using testing::drawRoom;
using testing::makeCostmap;
using testing::scanFrom;

SpeedLimits racingLimits()
{
  SpeedLimits limits;
  limits.max_vel_x = 4.0;
  limits.max_vel_theta = 10.0;
  limits.acc_lim_x = 2.0;
  limits.dec_lim_x = 3.0;
  return limits;
}

const Costmap & hall()
{
  static const Costmap costmap = makeCostmap(drawRoom(40.0, 12.0));
  return costmap;
}

TEST(SpeedProfile, standsAtTheEnd)
{
  const Path path = samplePath({1.0, 5.0, 0.0}, {{20.0, 0.0}}, 0.1);
  const std::vector<double> speeds = speedProfile(path, hall(), racingLimits());
  EXPECT_DOUBLE_EQ(speeds.back(), 0.0);
  EXPECT_DOUBLE_EQ(speeds.front(), 4.0);
}

TEST(SpeedProfile, neverChangesFasterThanTheLimits)
{
  const Path path = samplePath({1.0, 5.0, 0.0}, {{10.0, 0.0}, {2.0, 1.2}, {10.0, 0.0}}, 0.1);
  const std::vector<double> speeds = speedProfile(path, hall(), racingLimits());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step = path[i].s - path[i - 1].s;
    const double acceleration = (speeds[i] * speeds[i] - speeds[i - 1] * speeds[i - 1]) / (2.0 * step);
    EXPECT_LE(acceleration, 2.0 + 1e-6) << i;
    EXPECT_GE(acceleration, -3.0 - 1e-6) << i;
  }
}

TEST(SpeedProfile, keepsTheLateralAccelerationInBends)
{
  const Path path = samplePath({20.0, 1.0, 0.0}, {{3.0, 0.5}}, 0.1);
  const std::vector<double> speeds = speedProfile(path, hall(), racingLimits());
  EXPECT_NEAR(speeds.front(), std::sqrt(3.0 / 0.5), 1e-9);
}

TEST(SpeedProfile, drivesBendsMoreSlowlyNearToWhatTheMapDoesNotKnow)
{
  Costmap costmap = hall();
  const Vec2 seen{26.0, 6.0};
  costmap.observe(scanFrom({23.0, 6.0, 0.0}, [](double angle) { return std::abs(angle) < 0.1 ? 3.0 : 20.0; }));
  const Path path = samplePath({20.0, 1.0, 0.0}, {{9.0, 0.2}}, 0.1);
  SpeedLimits limits = racingLimits();
  limits.max_lateral_acceleration = 1.0;
  const std::vector<double> speeds = speedProfile(path, costmap, limits);
  const std::size_t nearest = nearestTo(path, {seen.x, seen.y, 0.0});
  ASSERT_GT(distance(path.front().pose.position(), seen), 2.6);
  EXPECT_NEAR(speeds.front(), std::sqrt(1.0 / 0.2), 1e-9) << "far from it";
  EXPECT_NEAR(speeds[nearest], std::sqrt(0.7 / 0.2), 1e-9);
}

TEST(SpeedProfile, squeezesPastWhatTheMapDoesNotKnowMoreSlowlyThanPastAWall)
{
  SpeedLimits limits = racingLimits();
  limits.full_speed_clearance = 0.1;
  const Path path = samplePath({20.0, 5.0, 0.0}, {{10.0, 0.0}}, 0.1);
  const auto slowest = [&](const Costmap & costmap) {
    const std::vector<double> speeds = speedProfile(path, costmap, limits);
    return *std::min_element(speeds.begin() + 30, speeds.begin() + 60);
  };
  Costmap costmap = hall();
  EXPECT_DOUBLE_EQ(slowest(costmap), 4.0);
  costmap.observe(scanFrom({22.0, 5.5, 0.0}, [](double angle) { return std::abs(angle) < 0.03 ? 3.0 : 20.0; }));
  const double clearance = costmap.clearance({25.0, 5.0, 0.0});
  ASSERT_GT(clearance, 0.2);
  EXPECT_LT(slowest(costmap), 3.0);
}

TEST(SpeedProfile, leavesTheWheelsTheAngleThatUndersteerTakes)
{
  SpeedLimits limits = racingLimits();
  limits.max_lateral_acceleration = 7.5;
  limits.understeer_gradient = 0.0028;
  const auto lateral = [&](double curvature) {
    const Path path = samplePath({20.0, 4.0, 0.0}, {{2.0, curvature}}, 0.1);
    return std::pow(speedProfile(path, hall(), limits).front(), 2) * std::abs(curvature);
  };
  EXPECT_NEAR(lateral(1.0), 7.5, 1e-9) << "the tyres decide";
  EXPECT_NEAR(lateral(-1.2), (0.4189 - 0.025 - std::atan(0.3302 * 1.2)) / 0.0028, 1e-6) << "the wheels decide";
  EXPECT_NEAR(lateral(1.34), 0.2 * 7.5, 1e-9) << "nothing is left";
  limits.understeer_gradient = 0.0;
  EXPECT_NEAR(lateral(1.34), 7.5, 1e-9);
}

TEST(SpeedProfile, keepsTheYawRateInBends)
{
  SpeedLimits limits = racingLimits();
  limits.max_vel_theta = 0.5;
  const Path path = samplePath({20.0, 1.0, 0.0}, {{3.0, 0.5}}, 0.1);
  EXPECT_NEAR(speedProfile(path, hall(), limits).front(), 1.0, 1e-9);
}

TEST(SpeedProfile, slowsWhereTheWheelsMustTurnQuickly)
{
  const Path path = samplePath({20.0, 5.0, 0.0}, {{3.0, 1.0}, {3.0, -1.0}}, 0.1);
  const std::vector<double> speeds = speedProfile(path, hall(), racingLimits());
  EXPECT_LT(speeds[30], std::sqrt(3.0 / 1.0) - 0.1);
}

TEST(SpeedProfile, slowsBesideObstacles)
{
  const Path path = samplePath({2.0, 0.4, 0.0}, {{20.0, 0.0}}, 0.1);
  EXPECT_LT(speedProfile(path, hall(), racingLimits()).front(), 2.0);
}

TEST(SpeedProfile, isDrivenWithCaution)
{
  const Path bend = samplePath({20.0, 2.0, 0.0}, {{6.0, 0.5}}, 0.1);
  const auto speedAt = [&](std::size_t i, const Caution & caution) {
    return speedProfile(bend, hall(), racingLimits(), caution)[i];
  };
  const double usual = speedAt(20, {});
  EXPECT_NEAR(speedAt(20, {0.5}), std::sqrt(0.5) * usual, 0.01);
  EXPECT_NEAR(speedAt(20, {1.0, 0.7, 2.5}), 0.7, 1e-9);
  EXPECT_GT(speedAt(35, {1.0, 0.7, 2.5}), 0.8);
  EXPECT_NEAR(speedAt(35, {1.0, 0.7, HUGE_VAL}), 0.7, 1e-9);
}

TEST(SpeedProfile, standsWhereTheDirectionChangesAndReversesSlowly)
{
  const Path path = samplePath({20.0, 5.0, 0.0}, {{3.0, 0.0}, {-3.0, 0.0}}, 0.1);
  const std::vector<double> speeds = speedProfile(path, hall(), racingLimits());
  EXPECT_DOUBLE_EQ(speeds[30], 0.0);
  EXPECT_DOUBLE_EQ(speeds[40], racingLimits().max_vel_x_backwards);
}

TEST(SpeedLimits, areChecked)
{
  SpeedLimits limits;
  limits.max_vel_x = -1.0;
  EXPECT_THROWS_MESSAGE(limits.validate(), OptionError, "max_vel_x: found -1, must be a number above 0");
  limits = {};
  limits.min_vel_x = 1.0;
  EXPECT_THROWS_MESSAGE(limits.validate(), OptionError, "min_vel_x: found 1, must be above 0 and at most max_vel_x");
  limits = {};
  limits.max_steering_angle = 2.0;
  EXPECT_THROWS_MESSAGE(limits.validate(), OptionError, "max_steering_angle: found 2, must be above 0 and below pi/2");
  limits = {};
  limits.full_speed_clearance = 0.01;
  EXPECT_THROWS_MESSAGE(
    limits.validate(), OptionError, "full_speed_clearance: found 0.01, must be above slowest_clearance");
}
}  // namespace
}  // namespace f1tenth_racer
