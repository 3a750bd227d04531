#include "node/cars/controllers/steering_odometry.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace f1tenth_sim2d;

TEST(SteeringOdometry, GoesAQuarterOfACircle)
{
  SteeringOdometry odometry(10);
  constexpr int kSteps = 1000;
  const double turn = M_PI / 2.0 / kSteps;
  for (int i = 0; i < kSteps; ++i) {
    odometry.advance(2.0 * turn, turn, 0.005);
  }
  EXPECT_NEAR(odometry.pose().x, 2.0, 1e-6);
  EXPECT_NEAR(odometry.pose().y, 2.0, 1e-6);
  EXPECT_NEAR(odometry.pose().yaw, M_PI / 2.0, 1e-12);
}

TEST(SteeringOdometry, AveragesSpeedsOverItsWindow)
{
  SteeringOdometry odometry(2);
  EXPECT_EQ(odometry.speed(), 0.0);
  odometry.advance(0.1, 0.0, 0.1);
  EXPECT_DOUBLE_EQ(odometry.speed(), 1.0);
  odometry.advance(0.3, 0.2, 0.1);
  EXPECT_DOUBLE_EQ(odometry.speed(), 2.0);
  EXPECT_DOUBLE_EQ(odometry.yawRate(), 1.0);
  odometry.advance(0.3, 0.2, 0.1);
  EXPECT_DOUBLE_EQ(odometry.speed(), 3.0);
}
