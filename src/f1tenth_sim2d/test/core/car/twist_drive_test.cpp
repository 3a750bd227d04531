#include <gtest/gtest.h>

#include <cmath>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
namespace
{
using Kind = DriveDescription::Kind;

VehicleParameters exact()
{
  VehicleParameters parameters;
  parameters.odometry_speed_noise_stddev = 0.0;
  return parameters;
}

CarDescription driven(Kind kind)
{
  CarDescription description = car("robot1");
  description.drive.emplace();
  description.drive->kind = kind;
  return description;
}

Simulation simulationOf(const CarDescription & description, const WorldDescription & around = world())
{
  Simulation simulation(around);
  simulation.addCar(description, exact(), {});
  return simulation;
}

/// Gives a Twist every step.
void go(Simulation & simulation, double seconds, const Vec2 & linear, double angular_z)
{
  for (const SimTime end = simulation.time() + fromSeconds(seconds); simulation.time() < end; simulation.step()) {
    simulation.commandTwist(kRobot1, linear.x, angular_z, linear.y);
  }
}
}  // namespace

TEST(TwistDrive, DifferentialTurnsOnTheSpot)
{
  Simulation simulation = simulationOf(driven(Kind::kDifferential));
  go(simulation, 2.0, {0.0, 0.0}, 1.5);
  const CarState & state = simulation.state(kRobot1);
  EXPECT_NEAR(state.yaw_rate, 1.5, 1e-12);
  EXPECT_NEAR(state.pose.x, 0.0, 1e-6);
  EXPECT_NEAR(state.pose.y, 0.0, 1e-6);
  EXPECT_NEAR(state.pose.yaw, 1.5 * 2.0, 0.1);
  EXPECT_NEAR(state.wheel_speeds[3], -state.wheel_speeds[2], 1e-9);
  EXPECT_NEAR(state.wheel_speeds[3], 1.5 * 0.1 / 0.05, 1e-9);
}

TEST(TwistDrive, DifferentialFollowsACircleAndDoesNotGoSideways)
{
  Simulation simulation = simulationOf(driven(Kind::kDifferential));
  go(simulation, 0.5, {1.0, 0.7}, 2.0);
  const CarState & state = simulation.state(kRobot1);
  EXPECT_NEAR(state.velocity.x, 1.0, 1e-9);
  EXPECT_NEAR(state.velocity.y, 0.0, 1e-9);
  const Pose2 start = state.pose;
  go(simulation, 3.141593, {1.0, 0.0}, 2.0);
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, start.x, 2e-3);
  EXPECT_NEAR(simulation.state(kRobot1).pose.y, start.y, 2e-3);
}

TEST(TwistDrive, SkidSteerTurnsAboutTheMiddleBetweenItsAxles)
{
  Simulation simulation = simulationOf(driven(Kind::kSkidSteer));
  const double half = 0.5 * exact().wheelbase();
  go(simulation, 1.0, {0.0, 0.0}, 2.0);
  const Pose2 & pose = simulation.state(kRobot1).pose;
  EXPECT_GT(std::abs(pose.yaw), 1.0);
  EXPECT_NEAR(pose.x + half * std::cos(pose.yaw), half, 1e-5);
  EXPECT_NEAR(pose.y + half * std::sin(pose.yaw), 0.0, 1e-5);
}

TEST(TwistDrive, PlanarGoesSideways)
{
  Simulation simulation = simulationOf(driven(Kind::kPlanarMove));
  go(simulation, 1.0, {0.0, -0.5}, 0.0);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.y, -0.5, 1e-9);
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, 0.0, 1e-9);
  EXPECT_NEAR(simulation.state(kRobot1).pose.y, -0.5, 0.05);
}

TEST(TwistDrive, AcceleratesNoFasterThanItsWheels)
{
  CarDescription description = driven(Kind::kDifferential);
  description.drive->acceleration_max = 0.5;
  Simulation simulation = simulationOf(description);
  go(simulation, 1.0, {2.0, 0.0}, 0.0);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 0.5 * (1.0 - exact().actuation_latency), 1e-3);
  EXPECT_NEAR(simulation.state(kRobot1).acceleration.x, 0.5, 1e-9);
}

TEST(TwistDrive, StopsExactlyWithoutCommands)
{
  Simulation simulation = simulationOf(driven(Kind::kPlanarMove));
  go(simulation, 1.0, {1.0, 1.0}, 1.0);
  simulation.advanceTo(simulation.time() + fromSeconds(2.0));
  const CarState & state = simulation.state(kRobot1);
  EXPECT_EQ(state.velocity.x, 0.0);
  EXPECT_EQ(state.velocity.y, 0.0);
  EXPECT_EQ(state.yaw_rate, 0.0);
}

TEST(TwistDrive, StartsAsFromFreshAfterAReset)
{
  Simulation simulation = simulationOf(driven(Kind::kDifferential));
  go(simulation, 1.0, {1.0, 0.0}, 1.0);
  const Pose2 first = simulation.state(kRobot1).pose;
  simulation.reset();
  go(simulation, 1.0, {1.0, 0.0}, 1.0);
  EXPECT_EQ(simulation.state(kRobot1).pose.x, first.x);
  EXPECT_EQ(simulation.state(kRobot1).pose.y, first.y);
}

TEST(TwistDrive, ADriveCommandMeansTheYawRateOfItsSteeringAngle)
{
  Simulation simulation = simulationOf(driven(Kind::kDifferential));
  drive(simulation, kRobot1, {1.0, 0.3}, 1.0);
  EXPECT_NEAR(simulation.state(kRobot1).yaw_rate, std::tan(0.3) / exact().wheelbase(), 1e-9);
}

TEST(TwistDrive, OdometryFollowsWhereItGoes)
{
  for (const Kind kind : {Kind::kDifferential, Kind::kSkidSteer, Kind::kPlanarMove}) {
    Simulation simulation = simulationOf(driven(kind));
    go(simulation, 2.0, {0.8, 0.2}, 0.5);
    const CarState & state = simulation.state(kRobot1);
    const WheelOdometry odometry = simulation.wheelOdometry(kRobot1);
    EXPECT_NEAR(odometry.pose.x, state.pose.x, 0.005);
    EXPECT_NEAR(odometry.pose.y, state.pose.y, 0.005);
    EXPECT_NEAR(odometry.pose.yaw, state.pose.yaw, 0.001);
    EXPECT_NEAR(odometry.speed, state.velocity.x, 1e-6);
    EXPECT_NEAR(odometry.lateral_speed, state.velocity.y, 1e-6);
    EXPECT_NEAR(odometry.yaw_rate, 0.5, 1e-9);
  }
}

TEST(TwistDrive, IsStoppedByAWall)
{
  Simulation simulation = simulationOf(driven(Kind::kDifferential), world({wallAcross(1.0)}));
  go(simulation, 2.0, {1.0, 0.0}, 0.0);
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, 0.6, 0.01);
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
}

TEST(TwistDrive, ACarThatSteersIsNotDrivenByIt)
{
  CarDescription description = driven(Kind::kSkidSteer);
  description.mechanism.push_back({"hinge", JointDescription::Role::kSteeringLeft});
  Simulation simulation = simulationOf(description);
  go(simulation, 1.0, {0.0, 0.0}, 1.0);
  EXPECT_EQ(simulation.state(kRobot1).yaw_rate, 0.0);
  EXPECT_GT(simulation.state(kRobot1).steering_angle, 0.3);
}
}  // namespace f1tenth_sim2d::test
