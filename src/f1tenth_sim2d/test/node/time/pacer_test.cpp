#include "node/time/pacer.h"

#include <gtest/gtest.h>

using f1tenth_sim2d::Pacer;

namespace
{
const ros::WallTime kStart{1000, 0};
constexpr std::int64_t kSecond = 1000000000;

ros::WallTime after(double seconds)
{
  return kStart + ros::WallDuration(seconds);
}
}  // namespace

TEST(Pacer, FactorDividesWallTime)
{
  Pacer pacer(4.0);
  pacer.start(0, kStart);
  EXPECT_EQ(pacer.due(2 * kSecond, kStart), after(0.5));
}

TEST(Pacer, StartsAtAnyTime)
{
  Pacer pacer(1.0);
  pacer.start(5 * kSecond, kStart);
  EXPECT_EQ(pacer.due(6 * kSecond, kStart), after(1.0));
}

TEST(Pacer, WakingUpLateShiftsNothing)
{
  Pacer pacer(1.0);
  pacer.start(0, kStart);
  pacer.due(kSecond, after(1.2));
  EXPECT_EQ(pacer.due(2 * kSecond, after(1.2)), after(2.0));
}

TEST(Pacer, GoesOnFromWhereItIsWhenFarBehind)
{
  Pacer pacer(1.0);
  pacer.start(0, kStart);
  EXPECT_EQ(pacer.due(kSecond, after(9.0)), after(9.0));
  EXPECT_EQ(pacer.due(2 * kSecond, after(9.0)), after(10.0));
}
