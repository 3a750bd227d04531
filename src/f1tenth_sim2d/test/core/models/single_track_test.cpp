#include "core/models/single_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d::test
{
struct ReferenceRow
{
  SteeredInput input;
  BodyState state;
};

std::map<std::string, std::vector<ReferenceRow>> readReference()
{
  std::map<std::string, std::vector<ReferenceRow>> manoeuvres;
  std::ifstream file(F1TENTH_SIM2D_TEST_DATA "/single_track_reference.csv");
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream stream(line);
    std::string manoeuvre;
    double time;
    ReferenceRow row;
    BodyState & s = row.state;
    stream >> manoeuvre >> time >> row.input.steering_rate >> row.input.acceleration;
    stream >> s.x >> s.y >> s.delta >> s.v >> s.psi >> s.psi_dot >> s.beta;
    manoeuvres[manoeuvre].push_back(row);
  }
  return manoeuvres;
}

class AgainstCommonRoad : public ::testing::TestWithParam<const char *>
{
};

TEST_P(AgainstCommonRoad, StaysWithinACentimetreAndAFifthOfADegreeForFiveSeconds)
{
  const std::vector<ReferenceRow> rows = readReference()[GetParam()];
  ASSERT_EQ(rows.size(), 101u);
  SingleTrack model{VehicleParameters{}};
  BodyState state = rows[0].state;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const BodyState & expected = rows[i].state;
    ASSERT_LT(std::hypot(state.x - expected.x, state.y - expected.y), 0.01) << "row " << i;
    ASSERT_LT(std::abs(state.psi - expected.psi), 0.2 * M_PI / 180.0) << "row " << i;
    ASSERT_NEAR(state.v, expected.v, 0.01) << "row " << i;
    for (int step = 0; step < 50; ++step) {
      model.advance(state, rows[i].input, 0.001);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(
  Manoeuvres, AgainstCommonRoad, ::testing::Values("step_steer", "slalom", "brake_in_turn", "lift_off", "pull_away"),
  [](const auto & manoeuvre) { return std::string(manoeuvre.param); });

TEST(SingleTrack, IsSmoothWhereItTurnsKinematic)
{
  SingleTrack model{VehicleParameters{}};
  BodyState state;
  state.v = 0.3;
  state.delta = 0.3;
  double last_yaw_rate = 0.0;
  for (int i = 0; i < 600; ++i) {
    model.advance(state, {0.0, -0.5}, 0.001);
    if (i > 50) {
      ASSERT_LT(std::abs(state.psi_dot - last_yaw_rate), 0.005) << "v = " << state.v;
    }
    last_yaw_rate = state.psi_dot;
  }
  EXPECT_NEAR(state.v, 0.0, 1e-5);
}

TEST(SingleTrack, ReverseFollowsTheWheels)
{
  const VehicleParameters p;
  SingleTrack model{p};
  BodyState state;
  state.v = -1.0;
  state.delta = 0.2;
  for (int i = 0; i < 2000; ++i) {
    model.advance(state, {}, 0.001);
  }
  EXPECT_NEAR(state.v, -1.0, 0.02);
  EXPECT_NEAR(state.psi_dot, state.v * std::cos(state.beta) * std::tan(0.2) / p.wheelbase(), 1e-6);
  EXPECT_NEAR(state.beta, std::atan(std::tan(0.2) * p.l_r / p.wheelbase()), 1e-9);
}

TEST(SingleTrack, ReverseCannotTurnTighterThanTheTyresHold)
{
  const VehicleParameters p;
  SingleTrack model{p};
  BodyState state;
  state.v = -5.0;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 before = worldVelocity(state);
    model.advance(state, {i < 100 ? 3.2 : 0.0, 0.0}, 0.001);
    const Vec2 after = worldVelocity(state);
    const double acceleration = std::hypot(after.x - before.x, after.y - before.y) / 0.001;
    ASSERT_LT(acceleration, 1.05 * p.mu * 9.81) << "step " << i;
  }
}

TEST(SingleTrack, CarPushedSidewaysSlidesToAnExactStop)
{
  const VehicleParameters p;
  SingleTrack model{p};
  BodyState state;
  setBodyVelocity(state, {0.0, 2.0});
  const double stopping_time = 2.0 / (p.mu * 9.81);
  double energy = 1e9;
  for (int i = 0; i < static_cast<int>(stopping_time * 1000) + 5; ++i) {
    model.advance(state, {}, 0.001);
    const double now = p.m * state.v * state.v + p.I_z * state.psi_dot * state.psi_dot;
    ASSERT_LE(now, energy * (1.0 + 1e-9));
    energy = now;
  }
  EXPECT_EQ(bodyVelocity(state).y, 0.0);
  EXPECT_NEAR(state.y, 2.0 * 2.0 / (2.0 * p.mu * 9.81), 0.01);
}

TEST(SingleTrack, CarThatLostItsGripRegainsIt)
{
  SingleTrack model{VehicleParameters{}};
  BodyState state;
  setBodyVelocity(state, {2.0, 3.0});
  model.advance(state, {}, 0.001);
  EXPECT_TRUE(model.isSliding());
  for (int i = 0; i < 1000; ++i) {
    model.advance(state, {}, 0.001);
  }
  EXPECT_FALSE(model.isSliding());
  EXPECT_NEAR(state.beta, 0.0, 0.01);
  EXPECT_LT(state.v, 2.5);
}

TEST(SingleTrack, CarThatSlidesIsTurnedBackByItsRearAxle)
{
  // Beyond the grip the forces on the axles act against their slip: to the right on a car that slides to the left.
  SingleTrack model{VehicleParameters{}};
  BodyState state;
  setBodyVelocity(state, {1.0, 2.0});
  state.psi_dot = 3.0;
  model.restart(state);
  model.advance(state, {}, 0.001);
  EXPECT_TRUE(model.isSliding());
  const double friction = VehicleParameters{}.mu * 9.81 * 0.001;
  EXPECT_NEAR(bodyVelocity(state).y, 2.0 - 1.0 * 3.0 * 0.001 - friction, 1e-4);
  EXPECT_NEAR(bodyVelocity(state).x, 1.0 + 2.0 * 3.0 * 0.001, 1e-4);
}

TEST(SingleTrack, LongStepIsDividedWhereTheModelIsStiff)
{
  SingleTrack model{VehicleParameters{}};
  BodyState fine;
  fine.v = 0.11;
  fine.delta = 0.2;
  BodyState coarse = fine;
  for (int i = 0; i < 1000; ++i) {
    model.advance(fine, {}, 0.001);
  }
  for (int i = 0; i < 100; ++i) {
    model.advance(coarse, {}, 0.010);
  }
  EXPECT_NEAR(fine.x, coarse.x, 1e-9);
  EXPECT_NEAR(fine.psi, coarse.psi, 1e-9);
}

TEST(SingleTrack, BodyVelocityAndSpeedAreTwoViewsOfTheSame)
{
  for (const Vec2 velocity : {Vec2{3, 1}, Vec2{-3, 1}, Vec2{-2, -4}, Vec2{0, -1}, Vec2{0, 0}}) {
    BodyState state;
    setBodyVelocity(state, velocity);
    EXPECT_NEAR(bodyVelocity(state).x, velocity.x, 1e-12);
    EXPECT_NEAR(bodyVelocity(state).y, velocity.y, 1e-12);
    EXPECT_LE(std::abs(state.beta), M_PI / 2);
  }
}
}  // namespace f1tenth_sim2d::test
