// What is measured of a car while it drives: how late it answers, and how far it drifts.
#include <gtest/gtest.h>

#include "control/car_watch.h"
#include "sliding_car.h"
#include "tyres/response_lag.h"
#include "tyres/slip_watch.h"
#include "tyres/traction_watch.h"

namespace f1tenth_racer
{
namespace
{
using testing::SlidingCar;

constexpr double kStep = 0.025;            // s
constexpr double kLeastSpeedChange = 0.3;  // m/s

class AnswerOf : public ::testing::TestWithParam<double>
{
};

TEST_P(AnswerOf, aCarThatSpeedsUpTellsItsLatency)
{
  ResponseLag lag(kLeastSpeedChange);
  SlidingCar car({0.0, 0.0, 0.0}, 1.0, 1.05, GetParam());
  for (int i = 0; i < 40; ++i) {
    const double time = 5.0 + kStep * i;
    lag.noteAnswer(time, car.state().speed);
    const DriveCommand command{1.0 + 7.0 * kStep * i, 0.0};
    lag.noteCommand(time, command.speed);
    car.drive(command, kStep);
  }
  EXPECT_NEAR(lag.lag(0.1), 0.1 + GetParam(), 0.02) << "its speed control takes a tenth of a second besides";
}

TEST_P(AnswerOf, aCarThatTurnsTellsItsLatency)
{
  ResponseLag lag(0.1);
  SlidingCar car({0.0, 0.0, 0.0}, 4.0, 1.05, GetParam());
  for (int i = 0; i < 120; ++i) {
    const double time = 5.0 + kStep * i;
    const double curvature = 0.3 * std::sin(2.5 * time);
    lag.noteCommand(time, curvature);
    const double before = car.state().pose.yaw;
    car.drive({4.0, curvature}, kStep);
    lag.noteAnswer(time + 0.5 * kStep, (car.state().pose.yaw - before) / (4.0 * kStep));
  }
  EXPECT_NEAR(lag.lag(0.0), 0.035 + GetParam(), 0.015) << "its wheels and its yaw take their time besides";
}

INSTANTIATE_TEST_SUITE_P(ResponseLag, AnswerOf, ::testing::Values(0.0, 0.02, 0.05, 0.1));

TEST(ResponseLag, isWhatIsExpectedWhileNothingChanges)
{
  ResponseLag lag(kLeastSpeedChange);
  EXPECT_NEAR(lag.lag(0.11), 0.11, 1e-9);
  for (int i = 0; i < 100; ++i) {
    lag.noteCommand(kStep * i, 3.0);
    if (kStep * i > 0.5) {
      lag.noteAnswer(kStep * i, 2.5);
    }
  }
  EXPECT_NEAR(lag.lag(0.11), 0.11, 1e-9);
}

TEST(ResponseLag, beginsAgainWhenTimeJumpsBack)
{
  ResponseLag lag(kLeastSpeedChange);
  lag.noteCommand(100.0, 8.0);
  lag.noteCommand(1.0, 0.0);
  lag.noteAnswer(1.1, 0.0);
  EXPECT_NEAR(lag.lag(0.1), 0.1, 1e-9);
}

// What has been found of a car after some time, s, whose speed and yaw follow what it is told so late, s.
Lags lagsOf(double speed_lag, double yaw_lag, double duration)
{
  constexpr double kStraight = 3.0;  // s
  const auto speed = [](double time) { return time > 0.0 ? 3.0 - 3.0 * std::cos(2.0 * time) : 0.0; };
  const auto bend = [](double time) { return time > kStraight ? 0.5 * std::sin(2.0 * (time - kStraight)) : 0.0; };
  CarWatch watch{FollowerOptions{}};
  CarState car;
  for (double time = 0.0; time < duration; time += kStep) {
    watch.note({car, time, time}, time);
    watch.noteCommand(time, {speed(time), bend(time)}, bend(time));
    car.speed = speed(time + kStep - speed_lag);
    car.pose = advance(car.pose, car.speed * kStep, bend(time + 0.5 * kStep - yaw_lag));
  }
  return watch.lags();
}

TEST(CarWatch, takesTheLatencyFromTheYawOnceTheCarHasTurned)
{
  const Lags straight = lagsOf(0.25, 0.1, 2.5);
  EXPECT_NEAR(straight.speed, 0.25, 0.005);
  EXPECT_NEAR(straight.latency, 0.25 - Handling::kSpeedLag, 0.005) << "as late as the speed, for all it knows";
  const Lags turned = lagsOf(0.25, 0.1, 6.0);
  EXPECT_NEAR(turned.speed, 0.25, 0.005);
  EXPECT_NEAR(turned.latency, 0.13, 0.015) << "tyres that slide pass on a speed later";
}

TEST(CarWatch, takesTheLatencyForNoLessThanItIsTold)
{
  EXPECT_EQ(lagsOf(0.2, 0.0, 6.0).latency, FollowerOptions{}.latency);
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

TEST(TractionWatch, tellsNothingOfWhoIsHeld)
{
  TractionWatch watch(7.0);
  watch.noteCommand({3.0, 0.0});
  for (int i = 0; i < 80; ++i) {
    watch.noteSpeed(0.025 * i, 0.0);
  }
  EXPECT_EQ(watch.share(), 1.0);
}

TEST(TractionWatch, beginsAgainWhenTimeJumpsBack)
{
  TractionWatch watch(7.0);
  watch.noteCommand({3.0, 0.0});
  for (const double start : {100.0, 1.0}) {
    for (int i = 0; i < 15; ++i) {
      watch.noteSpeed(start + 0.025 * i, 0.5);
    }
  }
  EXPECT_EQ(watch.share(), 1.0) << "too short to tell";
}
}  // namespace
}  // namespace f1tenth_racer
