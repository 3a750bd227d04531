#include "node/cars/controllers/pid.h"

#include <gtest/gtest.h>

using f1tenth_sim2d::Pid;

namespace
{
constexpr double kStep = 0.01;   // s
constexpr double kLimit = 10.0;  // N m
}  // namespace

TEST(Pid, EffortIsProportionalToTheErrorUpToTheLimit)
{
  Pid pid({2.0, 0.0, 0.0, 0.0});
  EXPECT_DOUBLE_EQ(pid.effort(1.5, kStep, kLimit), 3.0);
  EXPECT_DOUBLE_EQ(pid.effort(100.0, kStep, kLimit), kLimit);
  EXPECT_DOUBLE_EQ(pid.effort(-100.0, kStep, kLimit), -kLimit);
}

TEST(Pid, IntegralGrowsUpToItsClamp)
{
  Pid pid({0.0, 100.0, 0.0, 2.5});
  EXPECT_DOUBLE_EQ(pid.effort(1.0, kStep, kLimit), 1.0);
  EXPECT_DOUBLE_EQ(pid.effort(1.0, kStep, kLimit), 2.0);
  EXPECT_DOUBLE_EQ(pid.effort(1.0, kStep, kLimit), 2.5);
}

TEST(Pid, DerivativeBeginsWithTheSecondError)
{
  Pid pid({0.0, 0.0, 0.5, 0.0});
  EXPECT_DOUBLE_EQ(pid.effort(1.0, kStep, kLimit), 0.0);
  EXPECT_NEAR(pid.effort(1.1, kStep, kLimit), 0.5 * 0.1 / kStep, 1e-9);
}

TEST(Pid, BringsAWheelToItsSpeedWithALag)
{
  const double inertia = 0.05;  // kg m^2
  Pid pid({0.5, 1.0, 0.0, 1.0});
  double speed = 0.0;
  for (int i = 0; i < 5; ++i) {
    speed += pid.effort(20.0 - speed, kStep, kLimit) / inertia * kStep;
  }
  EXPECT_GT(speed, 1.0);
  EXPECT_LT(speed, 15.0);
  for (int i = 0; i < 2000; ++i) {
    speed += pid.effort(20.0 - speed, kStep, kLimit) / inertia * kStep;
  }
  EXPECT_NEAR(speed, 20.0, 0.1);
}
