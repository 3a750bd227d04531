#include "core/components/imu/imu.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
namespace
{
using Sample = std::array<double, Imu::kSize>;

CarDescription carWithImu(double stddev, double yaw = 0.0)
{
  CarDescription description = car("robot1");
  const Mount mount{"imu", "imu", "imu", Pose3(0.0, 0.0, 0.1, 0.0, 0.0, yaw), 100.0};
  description.components = {std::make_shared<Imu>(mount, Imu::Noise{stddev, stddev})};
  return description;
}

Sample sampleOf(const Simulation & simulation)
{
  Sample sample{};
  simulation.components(kRobot1).back()->sample(simulation, kRobot1, sample.data());
  return sample;
}
}  // namespace

TEST(Imu, MeasuresWhatTheCarDoes)
{
  Simulation simulation(world());
  simulation.addCar(carWithImu(0.0), {}, {});
  drive(simulation, kRobot1, {2.0, 0.15}, 3.0);
  const CarState & state = simulation.state(kRobot1);
  const Sample sample = sampleOf(simulation);
  EXPECT_NEAR(2.0 * std::atan2(sample[Imu::kOrientation + 2], sample[Imu::kOrientation + 3]), state.pose.yaw, 1e-12);
  EXPECT_EQ(sample[Imu::kAngularVelocity + 2], state.yaw_rate);
  EXPECT_NEAR(sample[Imu::kAcceleration + 1], state.velocity.x * state.yaw_rate, 0.05);
  EXPECT_EQ(sample[Imu::kAcceleration + 2], 9.8);
}

TEST(Imu, MeasuresAlongItsOwnAxes)
{
  Simulation simulation(world());
  simulation.addCar(carWithImu(0.0, M_PI / 2), {}, {});
  drive(simulation, kRobot1, {4.0, 0.0}, 0.25);
  const Sample sample = sampleOf(simulation);
  EXPECT_NEAR(2.0 * std::atan2(sample[Imu::kOrientation + 2], sample[Imu::kOrientation + 3]), M_PI / 2, 1e-9);
  EXPECT_NEAR(sample[Imu::kAcceleration + 1], -simulation.state(kRobot1).acceleration.x, 1e-9);
  EXPECT_LT(sample[Imu::kAcceleration + 1], -1.0);
}

TEST(Imu, NoiseIsAFunctionOfTime)
{
  Simulation simulation(world());
  simulation.addCar(carWithImu(0.1), {}, {});
  const Sample first = sampleOf(simulation);
  EXPECT_NE(first[Imu::kAngularVelocity + 2], 0.0);
  EXPECT_NE(first[Imu::kAcceleration], 0.0);
  EXPECT_NE(first[Imu::kAcceleration + 1], 0.0);
  EXPECT_EQ(sampleOf(simulation), first);
  simulation.step();
  EXPECT_NE(sampleOf(simulation), first);
}
}  // namespace f1tenth_sim2d::test
