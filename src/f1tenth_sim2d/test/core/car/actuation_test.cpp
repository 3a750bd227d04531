#include "core/car/actuation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
constexpr SimTime kMillisecond = 1'000'000;

TEST(Actuation, CommandTakesEffectAfterTheLatency)
{
  Simulation simulation(world());
  VehicleParameters parameters;
  parameters.actuation_latency = 0.05;
  simulation.addCar(car("robot1"), parameters, {});
  simulation.command(kRobot1, {1.0, 0.3});
  simulation.advanceTo(50 * kMillisecond);
  EXPECT_EQ(simulation.state(kRobot1).steering_angle, 0.0);
  EXPECT_EQ(simulation.state(kRobot1).velocity.x, 0.0);
  simulation.step();
  EXPECT_NEAR(simulation.state(kRobot1).steering_angle, 0.0032, 1e-12);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 0.00951, 1e-4);
}

TEST(Actuation, CommandsTakeEffectInTheirOrder)
{
  Actuation actuation{VehicleParameters{}};
  actuation.command({0.0, 0.4}, 0);
  actuation.command({0.0, -0.4}, 5 * kMillisecond);
  EXPECT_EQ(actuation.input(0.0, 0.0, 19 * kMillisecond, 0.001).steering_rate, 0.0);
  EXPECT_GT(actuation.input(0.0, 0.0, 20 * kMillisecond, 0.001).steering_rate, 0.0);
  EXPECT_LT(actuation.input(0.0, 0.0, 25 * kMillisecond, 0.001).steering_rate, 0.0);
}

TEST(Actuation, SteeringIsLimitedInRateAndAngle)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {0.0, 2.0}, 0.1);
  EXPECT_NEAR(simulation.state(kRobot1).steering_angle, 3.2 * 0.08, 1e-9);
  drive(simulation, kRobot1, {0.0, 2.0}, 0.2);
  EXPECT_NEAR(simulation.state(kRobot1).steering_angle, 0.4189, 1e-12);
  drive(simulation, kRobot1, {0.0, -2.0}, 0.5);
  EXPECT_NEAR(simulation.state(kRobot1).steering_angle, -0.4189, 1e-12);
}

TEST(Actuation, SpeedIsLimitedBothWays)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {100.0, 0.0}, 6.0);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 20.0, 0.05);
  drive(simulation, kRobot1, {-100.0, 0.0}, 6.0);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, -5.0, 0.05);
}

TEST(Actuation, AccelerationIsLimitedAndFallsAboveTheSwitchingSpeed)
{
  const VehicleParameters p;
  EXPECT_EQ(limitedAcceleration(1.0, 50.0, p), 9.51);
  EXPECT_EQ(limitedAcceleration(1.0, -50.0, p), -9.51);
  EXPECT_DOUBLE_EQ(limitedAcceleration(2 * p.v_switch, 50.0, p), 9.51 / 2);
  EXPECT_EQ(limitedAcceleration(2 * p.v_switch, -50.0, p), -9.51);
  EXPECT_EQ(limitedAcceleration(p.v_max, 1.0, p), 0.0);
  EXPECT_EQ(limitedAcceleration(p.v_min, -1.0, p), 0.0);
  EXPECT_EQ(limitedAcceleration(p.v_min, 1.0, p), 1.0);
}

TEST(Actuation, CarWithoutCommandsBrakesToAnExactStop)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {3.0, 0.0}, 1.0);
  simulation.advanceTo(simulation.time() + fromSeconds(0.49));
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 3.0, 0.05);
  simulation.advanceTo(simulation.time() + fromSeconds(2.0));
  EXPECT_EQ(simulation.state(kRobot1).velocity.x, 0.0);
  const Pose2 stopped = simulation.state(kRobot1).pose;
  simulation.advanceTo(simulation.time() + fromSeconds(1.0));
  EXPECT_EQ(simulation.state(kRobot1).pose.x, stopped.x);
}

TEST(Actuation, TimeoutBeginsWhenACommandTakesEffect)
{
  VehicleParameters parameters;
  parameters.actuation_latency = 0.6;
  Actuation actuation{parameters};
  actuation.command({2.0, 0.0}, 0);
  EXPECT_EQ(actuation.input(0.0, 0.0, 599 * kMillisecond, 0.001).acceleration, 0.0);
  EXPECT_GT(actuation.input(0.0, 0.0, 600 * kMillisecond, 0.001).acceleration, 0.0);
  EXPECT_GT(actuation.input(0.0, 0.0, 1100 * kMillisecond, 0.001).acceleration, 0.0);
  EXPECT_EQ(actuation.input(0.0, 0.0, 1101 * kMillisecond, 0.001).acceleration, 0.0);
}

TEST(Actuation, TwistTurnsAboutTheRearAxle)
{
  const double wheelbase = 0.33;
  EXPECT_NEAR(commandFromTwist(2.0, 1.0, wheelbase).steering_angle, std::atan(wheelbase / 2.0), 1e-12);
  EXPECT_NEAR(commandFromTwist(-2.0, 1.0, wheelbase).steering_angle, -std::atan(wheelbase / 2.0), 1e-12);
  EXPECT_EQ(commandFromTwist(2.0, 0.0, wheelbase).steering_angle, 0.0);
  EXPECT_EQ(commandFromTwist(0.0, 0.0, wheelbase).steering_angle, 0.0);
  EXPECT_GT(commandFromTwist(0.0, 1.0, wheelbase).steering_angle, 1.0);
  EXPECT_LT(commandFromTwist(0.0, -1.0, wheelbase).steering_angle, -1.0);
  EXPECT_EQ(commandFromTwist(-2.0, 1.0, wheelbase).speed, -2.0);
}

TEST(Actuation, TwistReachesTheYawRateItAsksFor)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  for (int i = 0; i < 2000; ++i) {
    simulation.commandTwist(kRobot1, 0.5, 0.4);
    simulation.step();
  }
  EXPECT_NEAR(simulation.state(kRobot1).yaw_rate, 0.4, 0.01);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 0.5, 0.01);
}
}  // namespace f1tenth_sim2d::test
