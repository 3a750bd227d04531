#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/math/noise.h"
#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/ackermann.h"
#include "sample_world.h"

namespace f1tenth_sim2d::test
{
VehicleParameters withoutOdometryNoise()
{
  VehicleParameters parameters;
  parameters.odometry_speed_noise_stddev = 0.0;
  parameters.odometry_steering_noise_stddev = 0.0;
  return parameters;
}

TEST(WheelOdometry, FollowsTheCarWhenItIsExact)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), withoutOdometryNoise(), {1.0, 2.0, 0.5});
  EXPECT_EQ(simulation.wheelOdometry(kRobot1).pose.x, 1.0);
  EXPECT_EQ(simulation.wheelOdometry(kRobot1).pose.yaw, 0.5);
  drive(simulation, kRobot1, {0.4, 0.1}, 5.0);
  const Pose2 truth = simulation.state(kRobot1).pose;
  const WheelOdometry odometry = simulation.wheelOdometry(kRobot1);
  EXPECT_NEAR(odometry.pose.x, truth.x, 0.05);
  EXPECT_NEAR(odometry.pose.y, truth.y, 0.05);
  EXPECT_NEAR(normalizeAngle(odometry.pose.yaw - truth.yaw), 0.0, 0.05);
  EXPECT_NEAR(odometry.speed, simulation.state(kRobot1).velocity.x, 1e-3);
  EXPECT_NEAR(odometry.yaw_rate, simulation.state(kRobot1).yaw_rate, 0.02);
}

TEST(WheelOdometry, GoesAlongChordsOfItsBend)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), withoutOdometryNoise(), {});
  drive(simulation, kRobot1, {1.0, 0.3}, 3.0);
  const Pose2 before = simulation.wheelOdometry(kRobot1).pose;
  drive(simulation, kRobot1, {1.0, 0.3}, 1.0);
  const Pose2 after = simulation.wheelOdometry(kRobot1).pose;
  const double turn = normalizeAngle(after.yaw - before.yaw);
  const double course = std::atan2(after.y - before.y, after.x - before.x);
  EXPECT_GT(turn, 0.5);
  EXPECT_NEAR(normalizeAngle(course - before.yaw), 0.5 * turn, 1e-3);
}

TEST(WheelOdometry, DriftsBySystematicErrors)
{
  VehicleParameters parameters = withoutOdometryNoise();
  parameters.odometry_speed_scale = 1.1;
  Simulation simulation(world());
  simulation.addCar(car("scaled"), parameters, {});
  parameters.odometry_speed_scale = 1.0;
  parameters.odometry_steering_offset = 0.02;
  simulation.addCar(car("skewed"), parameters, {0, 3, 0});
  for (int i = 0; i < 3000; ++i) {
    simulation.command(kRobot1, {1.0, 0.0});
    simulation.command(kRobot2, {1.0, 0.0});
    simulation.step();
  }
  EXPECT_NEAR(simulation.wheelOdometry(kRobot1).pose.x, 1.1 * simulation.state(kRobot1).pose.x, 1e-6);
  EXPECT_GT(simulation.wheelOdometry(kRobot2).pose.yaw, 0.1);
}

TEST(WheelOdometry, IsSampledAtItsRate)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {1.0, 0.0}, 0.5);
  int changes = 0;
  double last = simulation.wheelOdometry(kRobot1).pose.x;
  for (int i = 0; i < 1000; ++i) {
    simulation.command(kRobot1, {1.0, 0.0});
    simulation.step();
    changes += simulation.wheelOdometry(kRobot1).pose.x != last ? 1 : 0;
    last = simulation.wheelOdometry(kRobot1).pose.x;
  }
  EXPECT_EQ(changes, 50);
}

TEST(WheelOdometry, StandsStillWithTheWheels)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.advanceTo(1'000'000'000);
  EXPECT_EQ(simulation.wheelOdometry(kRobot1).speed, 0.0);
  EXPECT_EQ(simulation.wheelOdometry(kRobot1).pose.x, 0.0);
}

TEST(WheelOdometry, IsTheSameWhetherItIsReadOrNot)
{
  Simulation read(world());
  Simulation unread(world());
  read.addCar(car("robot1"), {}, {});
  unread.addCar(car("robot1"), {}, {});
  std::vector<float> ranges(1081);
  for (int i = 0; i < 500; ++i) {
    read.command(kRobot1, {1.0, 0.1});
    unread.command(kRobot1, {1.0, 0.1});
    read.step();
    unread.step();
    read.scan(kRobot1, 0, ranges.data());
    read.wheelOdometry(kRobot1);
  }
  EXPECT_EQ(read.wheelOdometry(kRobot1).pose.x, unread.wheelOdometry(kRobot1).pose.x);
  EXPECT_EQ(read.wheelOdometry(kRobot1).pose.yaw, unread.wheelOdometry(kRobot1).pose.yaw);
}

TEST(CarState, PoseIsThatOfTheRearAxle)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {1.0, -2.0, 0.7});
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, 1.0, 1e-12);
  EXPECT_NEAR(simulation.state(kRobot1).pose.y, -2.0, 1e-12);
  EXPECT_NEAR(simulation.state(kRobot1).pose.yaw, 0.7, 1e-12);
  drive(simulation, kRobot1, {0.5, 0.3}, 3.0);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.y, 0.0, 0.01) << "at low speed the rear axle does not slip";
}

TEST(CarState, VelocityIsTheDerivativeOfThePose)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {3.0, 0.15}, 2.0);
  const CarState before = simulation.state(kRobot1);
  simulation.command(kRobot1, {3.0, 0.15});
  simulation.step();
  const CarState & after = simulation.state(kRobot1);
  const double yaw = 0.5 * (before.pose.yaw + after.pose.yaw);
  const double dx = (after.pose.x - before.pose.x) / 0.001;
  const double dy = (after.pose.y - before.pose.y) / 0.001;
  EXPECT_NEAR(after.velocity.x, std::cos(yaw) * dx + std::sin(yaw) * dy, 1e-3);
  EXPECT_NEAR(after.velocity.y, std::cos(yaw) * dy - std::sin(yaw) * dx, 1e-3);
  EXPECT_NEAR(after.yaw_rate, (after.pose.yaw - before.pose.yaw) / 0.001, 1e-3);
}

TEST(CarState, WheelsRollAsFarAsTheCarGoes)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 2.0);
  const CarState & state = simulation.state(kRobot1);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(state.wheel_angles[i] * 0.05, state.pose.x, 1e-3);
    EXPECT_NEAR(state.wheel_speeds[i] * 0.05, 2.0, 0.01);
  }
}

TEST(Ackermann, WheelsTurnAboutOnePoint)
{
  const SteeringAngles angles = ackermannSteering(0.3, 0.33, 0.2);
  const double radius = 0.33 / std::tan(0.3);
  EXPECT_NEAR(std::tan(angles.left), 0.33 / (radius - 0.1), 1e-12);
  EXPECT_NEAR(std::tan(angles.right), 0.33 / (radius + 0.1), 1e-12);
  EXPECT_EQ(ackermannSteering(0.0, 0.33, 0.2).left, 0.0);
  EXPECT_DOUBLE_EQ(ackermannSteering(-0.3, 0.33, 0.2).right, -angles.left);
}

TEST(Ackermann, WheelSpeedsAreThoseOfCirclesAboutThatPoint)
{
  const double radius = 0.33 / std::tan(0.3);
  const double yaw_rate = 2.0 / radius;
  const auto speeds = wheelSpeeds(2.0, yaw_rate, 0.3, 0.33, 0.2, 0.05);
  EXPECT_NEAR(speeds[0], yaw_rate * std::hypot(radius - 0.1, 0.33) / 0.05, 1e-9);
  EXPECT_NEAR(speeds[1], yaw_rate * std::hypot(radius + 0.1, 0.33) / 0.05, 1e-9);
  EXPECT_NEAR(speeds[2], yaw_rate * (radius - 0.1) / 0.05, 1e-9);
  EXPECT_NEAR(speeds[3], yaw_rate * (radius + 0.1) / 0.05, 1e-9);
}

TEST(CarState, HasAllOfTheAccelerationOfACarThatSlides)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.placeCar(kRobot1, {}, {3.0, 1.0}, 2.0);
  const double l_r = VehicleParameters{}.l_r;
  const auto velocityInWorld = [&] {
    const CarState s = simulation.state(kRobot1);
    const Vec2 centre{s.velocity.x, s.velocity.y + l_r * s.yaw_rate};
    const double c = std::cos(s.pose.yaw);
    const double sn = std::sin(s.pose.yaw);
    return Vec2{c * centre.x - sn * centre.y, sn * centre.x + c * centre.y};
  };
  simulation.step();
  for (int i = 0; i < 50; ++i) {
    const Vec2 before = velocityInWorld();
    simulation.step();
    const Vec2 after = velocityInWorld();
    const double yaw = simulation.state(kRobot1).pose.yaw;
    const Vec2 change{(after.x - before.x) / 0.001, (after.y - before.y) / 0.001};
    const Vec2 acceleration = simulation.state(kRobot1).acceleration;
    ASSERT_NEAR(acceleration.x, std::cos(yaw) * change.x + std::sin(yaw) * change.y, 1e-6);
    ASSERT_NEAR(acceleration.y, std::cos(yaw) * change.y - std::sin(yaw) * change.x, 1e-6);
  }
}

TEST(Poses, KeepTheirYawWithinHalfATurn)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), withoutOdometryNoise(), {});
  double least = 0.0;
  double greatest = 0.0;
  double turned = 0.0;
  double last = 0.0;
  for (int i = 0; i < 400; ++i) {
    drive(simulation, kRobot1, {1.5, 0.35}, 0.02);
    const double yaw = simulation.state(kRobot1).pose.yaw;
    least = std::min({least, yaw, simulation.wheelOdometry(kRobot1).pose.yaw});
    greatest = std::max({greatest, yaw, simulation.wheelOdometry(kRobot1).pose.yaw});
    turned += std::remainder(yaw - last, 2.0 * M_PI);
    last = yaw;
  }
  EXPECT_GT(turned, 2.0 * M_PI);
  EXPECT_GE(least, -M_PI);
  EXPECT_LE(greatest, M_PI);
  EXPECT_LT(least, -3.0);
  EXPECT_GT(greatest, 3.0);
}
}  // namespace f1tenth_sim2d::test
