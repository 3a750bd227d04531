#include "node/cars/controllers/speed_limits.h"

#include <gtest/gtest.h>

using namespace f1tenth_sim2d;

TEST(SpeedLimits, AllowEverythingUnlessTheyAreSet)
{
  EXPECT_EQ(limited(7.0, 1.0, 0.0, 0.1, {}), 7.0);
}

TEST(SpeedLimits, BoundTheSpeed)
{
  SpeedLimits limits;
  limits.velocity = {-1.0, 2.0};
  EXPECT_EQ(limited(7.0, 0.0, 0.0, 0.1, limits), 2.0);
  EXPECT_EQ(limited(-7.0, 0.0, 0.0, 0.1, limits), -1.0);
}

TEST(SpeedLimits, BoundHowFastTheSpeedChanges)
{
  SpeedLimits limits;
  limits.acceleration = {-4.0, 2.0};
  EXPECT_DOUBLE_EQ(limited(7.0, 1.0, 1.0, 0.1, limits), 1.2);
  EXPECT_DOUBLE_EQ(limited(-7.0, 1.0, 1.0, 0.1, limits), 0.6);
}

TEST(SpeedLimits, BoundHowFastTheChangeChanges)
{
  SpeedLimits limits;
  limits.jerk = {-10.0, 5.0};
  // It has changed by 0.5, and may change by 2 * 5 * 0.1^2 = 0.1 more.
  EXPECT_DOUBLE_EQ(limited(7.0, 1.0, 0.5, 0.1, limits), 1.6);
  EXPECT_DOUBLE_EQ(limited(-7.0, 1.0, 0.5, 0.1, limits), 1.3);
}
