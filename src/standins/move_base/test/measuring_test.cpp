// What is measured of a car while it drives: how late it answers, and how far it drifts.
#include <gtest/gtest.h>

#include "control/slip_watch.h"
#include "control/speed_lag.h"
#include "control/traction_watch.h"
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

TEST(SlipWatch, hasFeltTheTyresAfterHalfASecondOfABend)
{
  SlipWatch watch(0.0178);
  SlidingCar car({0.0, 0.0, 0.0}, 4.0, 0.5, 0.0);
  const auto drive = [&](double from, double until, double curvature) {
    for (double time = from; time < until; time += kStep) {
      watch.note(time, car.state().pose);
      car.drive({4.0, curvature}, kStep);
    }
  };
  drive(0.0, 2.0, 0.0);
  EXPECT_FALSE(watch.hasFelt());
  drive(2.0, 3.5, 0.25);
  EXPECT_TRUE(watch.hasFelt());
  EXPECT_NEAR(watch.gradient(), 0.0374, 0.005);
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

// Share of 7 m/s^2 that a car reaches which speeds up to a speed, m/s, and answers late, s, with so much grip, m/s^2. What
// it is told is as far ahead of it as the follower lets it be.
double tractionOf(double grip, double acceleration, double latency, double start = 0.0)
{
  TractionWatch watch(7.0);
  std::deque<double> pending(static_cast<std::size_t>(std::lround(latency / 0.001)), start);
  double speed = start;
  double told = start;
  for (int i = 0; i < 1500; ++i) {
    if (i % 25 == 0) {
      told = std::min(told + 0.025 * acceleration, speed + 1.3 * (0.1 + latency) * 7.0);
      watch.noteCommand({told, 0.0});
      watch.noteSpeed(0.001 * i, speed);
    }
    pending.push_back(told);
    speed += 0.001 * std::min(grip, 10.0 * (pending.front() - speed));
    pending.pop_front();
  }
  return watch.share();
}

TEST(TractionWatch, measuresHowMuchOfItsAccelerationACarReaches)
{
  for (const double latency : {0.0, 0.05, 0.1}) {
    EXPECT_GT(tractionOf(9.5, 7.0, latency), 0.95) << latency;
    EXPECT_NEAR(tractionOf(3.0, 7.0, latency), 3.0 / 7.0, 0.02) << latency;
  }
}

TEST(TractionWatch, tellsNothingOfWhoNeedsLessOrIsFast)
{
  EXPECT_EQ(tractionOf(9.5, 2.0, 0.02), 1.0);
  EXPECT_EQ(tractionOf(3.0, 7.0, 0.02, 4.5), 1.0) << "the motor's power may be what it lacks";
}

TEST(TractionWatch, tellsNothingOfWhoCorners)
{
  TractionWatch watch(7.0);
  watch.noteCommand({3.5, 0.5});
  for (int i = 0; i < 40; ++i) {
    watch.noteSpeed(0.025 * i, 2.0 + 0.025 * i);
  }
  EXPECT_EQ(watch.share(), 1.0);
}

TEST(TractionWatch, beginsAgainWhenTimeJumpsBack)
{
  TractionWatch watch(7.0);
  watch.noteCommand({3.0, 0.0});
  for (const double start : {100.0, 1.0}) {
    for (int i = 0; i < 15; ++i) {
      watch.noteSpeed(start + 0.025 * i, 0.0);
    }
  }
  EXPECT_EQ(watch.share(), 1.0) << "too short to tell";
}
}  // namespace
}  // namespace move_base
