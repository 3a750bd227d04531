#include "control/dead_reckoning.h"

#include <gtest/gtest.h>

#include "kinematic_car.h"

namespace f1tenth_racer
{
namespace
{
const CarState kDriving{{1.0, 2.0, 0.5}, 3.0, 0.2};

TEST(DeadReckoning, leavesACarThatIsSeenNowWhereItIs)
{
  DeadReckoning reckoning;
  reckoning.note(9.9, {3.0, 0.5});
  const CarState state = reckoning.predict(kDriving, 10.0, 10.0, 10.0);
  EXPECT_EQ(state.pose.x, 1.0);
  EXPECT_EQ(state.pose.yaw, 0.5);
  EXPECT_EQ(state.speed, 3.0);
  EXPECT_EQ(state.yaw_rate, 0.2);
}

TEST(DeadReckoning, drivesTheArcOfTheCommandInForce)
{
  DeadReckoning reckoning;
  reckoning.note(9.9, {3.0, 0.5});
  const CarState state = reckoning.predict(kDriving, 10.0, 10.0, 10.2);
  const Pose2 wanted = advance(kDriving.pose, 0.6, 0.5);
  EXPECT_NEAR(distance(state.pose, wanted), 0.0, 1e-9);
  EXPECT_NEAR(state.pose.yaw, wanted.yaw, 1e-9);
}

TEST(DeadReckoning, takesCommandsInTurn)
{
  DeadReckoning reckoning;
  reckoning.note(9.0, {3.0, 0.0});
  reckoning.note(10.1, {3.0, 1.0});
  reckoning.note(10.2, {3.0, -1.0});
  const CarState state = reckoning.predict(kDriving, 10.0, 10.0, 10.3);
  EXPECT_NEAR(state.pose.yaw, 0.5, 1e-9) << "as far to the left as to the right";
}

TEST(DeadReckoning, comesNearACarThatBrakes)
{
  DeadReckoning reckoning;
  testing::KinematicCar car({0.0, 0.0, 0.0});
  for (int i = 0; i < 100; ++i) {
    car.drive({2.0, 0.3}, 0.05);
  }
  const CarState seen = car.state();
  for (int i = 0; i < 10; ++i) {
    const DriveCommand command{std::max(0.0, 2.0 - 0.4 * i), 0.3};
    reckoning.note(0.05 * i, command);
    car.drive(command, 0.05);
  }
  const CarState state = reckoning.predict(seen, 0.0, 0.0, 0.5);
  EXPECT_NEAR(distance(state.pose, car.state().pose), 0.0, 0.05);
  EXPECT_NEAR(state.speed, car.state().speed, 0.1);
}

TEST(DeadReckoning, brakesAnOldSpeedByTheCommandsSince)
{
  DeadReckoning reckoning;
  for (int i = 0; i < 40; ++i) {
    reckoning.note(10.0 + 0.05 * i, {std::max(0.0, 3.0 - 0.15 * i), 0.0});
  }
  const CarState state = reckoning.predict(kDriving, 12.0, 10.0, 12.0);
  EXPECT_EQ(state.pose.x, kDriving.pose.x) << "its pose was seen just now";
  EXPECT_LT(state.speed, 0.05);
}

TEST(DeadReckoning, believesASpeedThatWasMeasuredAfterItsPose)
{
  DeadReckoning reckoning;
  reckoning.note(9.0, {3.0, 0.0});
  reckoning.note(10.5, {0.0, 0.0});
  const CarState state = reckoning.predict({{0.0, 0.0, 0.0}, 2.0}, 10.0, 11.0, 11.0);
  EXPECT_EQ(state.speed, 2.0);
  EXPECT_GT(state.pose.x, 1.0);
}

TEST(DeadReckoning, knowsNothingWithoutCommands)
{
  DeadReckoning reckoning;
  reckoning.note(9.0, {3.0, 0.0});
  reckoning.clear();
  EXPECT_EQ(reckoning.predict(kDriving, 10.0, 10.0, 11.0).pose.x, 1.0);
}
}  // namespace
}  // namespace f1tenth_racer
