// What is measured of a car while it drives: how late it answers, and how far it drifts.
#include <gtest/gtest.h>

#include "control/slip_watch.h"
#include "control/speed_lag.h"
#include "sliding_car.h"

namespace move_base
{
namespace
{
using testing::SlidingCar;

constexpr double kStep = 0.025;  // s

class AnswerOf : public ::testing::TestWithParam<double>
{
};

TEST_P(AnswerOf, aCarThatSpeedsUpTellsItsLatency)
{
  SpeedLag lag(0.1);
  SlidingCar car({0.0, 0.0, 0.0}, 1.0, 1.05, GetParam());
  for (int i = 0; i < 40; ++i) {
    const double time = 5.0 + kStep * i;
    lag.noteSpeed(time, car.state().speed);
    const DriveCommand command{1.0 + 7.0 * kStep * i, 0.0};
    lag.noteCommand(time, command.speed);
    car.drive(command, kStep);
  }
  EXPECT_NEAR(lag.lag(), 0.1 + GetParam(), 0.02) << "its speed control takes a tenth of a second besides";
}

INSTANTIATE_TEST_SUITE_P(SpeedLag, AnswerOf, ::testing::Values(0.0, 0.02, 0.05, 0.1));

TEST(SpeedLag, isWhatIsExpectedWhileNothingChanges)
{
  SpeedLag lag(0.11);
  EXPECT_NEAR(lag.lag(), 0.11, 1e-9);
  for (int i = 0; i < 100; ++i) {
    lag.noteCommand(kStep * i, 3.0);
    if (kStep * i > 0.5) {
      lag.noteSpeed(kStep * i, 2.5);
    }
  }
  EXPECT_NEAR(lag.lag(), 0.11, 1e-9);
}

TEST(SpeedLag, beginsAgainWhenTimeJumpsBack)
{
  SpeedLag lag(0.1);
  lag.noteCommand(100.0, 8.0);
  lag.noteCommand(1.0, 0.0);
  lag.noteSpeed(1.1, 0.0);
  EXPECT_NEAR(lag.lag(), 0.1, 1e-9);
}

// The slip gradient of a car in a bend of 5 m.
double driftOf(double friction, double jump = 0.0)
{
  SlipWatch watch(0.0178);
  SlidingCar car({0.0, 0.0, 0.0}, 4.0, friction, 0.0);
  for (int i = 0; i < 120; ++i) {
    Pose2 pose = car.state().pose;
    pose.y += i == 60 ? jump : 0.0;
    watch.note(kStep * i, pose);
    car.drive({4.0, 0.2}, kStep);
  }
  return watch.gradient();
}

TEST(SlipWatch, measuresHowFarACarDriftsInBends)
{
  EXPECT_NEAR(driftOf(1.0489), 0.0178, 0.001);
  EXPECT_NEAR(driftOf(0.5), 0.0374, 0.003);
}

TEST(SlipWatch, isNotMisledByAPoseThatJumps)
{
  EXPECT_NEAR(driftOf(1.0489, 5.0), driftOf(1.0489), 0.002);
}

TEST(SlipWatch, isWhatIsExpectedOfACarThatDrivesStraightOn)
{
  SlipWatch watch(0.0178);
  for (int i = 0; i < 100; ++i) {
    watch.note(kStep * i, {0.1 * i, 0.0, 0.05});
  }
  EXPECT_DOUBLE_EQ(watch.gradient(), 0.0178);
}

TEST(SlipWatch, beginsAgainWhenTimeJumpsBack)
{
  SlipWatch watch(0.0178);
  for (const double start : {100.0, 1.0}) {
    for (int i = 0; i < 4; ++i) {
      watch.note(start + kStep * i, {start, 0.1 * i, 0.3 * i});
    }
  }
  EXPECT_DOUBLE_EQ(watch.gradient(), 0.0178) << "too short to tell";
}
}  // namespace
}  // namespace move_base
