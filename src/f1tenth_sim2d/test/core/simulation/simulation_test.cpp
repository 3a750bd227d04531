#include "f1tenth_sim2d/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "sample_world.h"

namespace f1tenth_sim2d::test
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The message of the Error that a call throws.
template <typename Call>
std::string messageOf(Call call)
{
  try {
    call();
  } catch (const Error & error) {
    return error.what();
  }
  return "no error";
}

TEST(Simulation, OccupiedStartNamesTheWallThatIsInTheWay)
{
  Simulation simulation(world({room(3.0)}));
  EXPECT_EQ(
    messageOf([&] {
      simulation.addCar(car("robot1"), {}, {0.5, -3.0, 0.1});
    }),
    "robot1: the start pose (0.5, -3, 0.1) is not free: it overlaps model walls::Wall_3");
  EXPECT_EQ(simulation.cars().size(), 0u);
}

TEST(Simulation, OccupiedStartNamesTheCarThatIsInTheWay)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(
    messageOf([&] {
      simulation.addCar(car("robot2"), {}, {0.2, 0.1, 0});
    }),
    "robot2: the start pose (0.2, 0.1, 0) is not free: it overlaps car robot1");
}

TEST(Simulation, NamesAreUnique)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(
    messageOf([&] {
      simulation.addCar(car("robot1"), {}, {5, 0, 0});
    }),
    "robot1: there is already a car of this name");
}

TEST(Simulation, CommandsThatAreNotFiniteAreRefusedAndNotTaken)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(
    messageOf([&] {
      simulation.command(kRobot1, {kNan, 0.0});
    }),
    "robot1: commanded speed (m/s) is nan, allowed is -100 to 100");
  EXPECT_EQ(
    messageOf([&] {
      simulation.command(kRobot1, {1.0, std::numeric_limits<double>::infinity()});
    }),
    "robot1: commanded steering angle (rad) is inf, allowed is -6.2832 to 6.2832");
  EXPECT_EQ(
    messageOf([&] { simulation.commandTwist(kRobot1, 1.0, kNan); }),
    "robot1: commanded yaw rate (rad/s) is nan, allowed is -1000 to 1000");
  EXPECT_NE(messageOf([&] { simulation.commandTwist(kRobot1, kNan, 1.0); }), "no error");
  simulation.advanceTo(500'000'000);
  EXPECT_EQ(simulation.state(kRobot1).velocity.x, 0.0);
  EXPECT_EQ(simulation.state(kRobot1).steering_angle, 0.0);
}

TEST(Simulation, CommandsBeyondTheLimitsAreClampedAndHarmless)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {100.0, -6.0}, 1.0);
  EXPECT_TRUE(std::isfinite(simulation.state(kRobot1).pose.x));
  EXPECT_NEAR(simulation.state(kRobot1).steering_angle, -0.4189, 1e-12);
}

TEST(Simulation, ImpactAfterAResetIsThatOfAFreshStartWhetherOrNotAnythingWasTouchedBefore)
{
  const auto impact = [](Simulation & simulation) {
    drive(simulation, kRobot1, {4.0, 0.2}, 2.0);
    std::vector<std::uint8_t> bytes;
    simulation.appendStateBytes(bytes);
    EXPECT_FALSE(simulation.contacts(kRobot1).empty());
    return bytes;
  };
  const auto simulationOfRoom = [] {
    Simulation simulation(world({room(2.0), movableBox("crate", 0.3, 1.5, 0.3)}));
    simulation.addCar(car("robot1"), {}, {});
    return simulation;
  };
  Simulation fresh = simulationOfRoom();
  const std::vector<std::uint8_t> expected = impact(fresh);
  Simulation again = simulationOfRoom();
  drive(again, kRobot1, {0.2, 0.0}, 0.5);
  EXPECT_TRUE(again.contacts(kRobot1).empty());
  again.reset();
  EXPECT_EQ(impact(again), expected);
  again.reset();
  EXPECT_EQ(impact(again), expected);
}

TEST(Simulation, ParametersThatAreNoCarsAreRefused)
{
  Simulation simulation(world());
  const auto errorWith = [&](double VehicleParameters::*member, double value) {
    VehicleParameters parameters;
    parameters.*member = value;
    return messageOf([&] { simulation.addCar(car("robot1"), parameters, {}); });
  };
  using P = VehicleParameters;
  EXPECT_EQ(errorWith(&P::m, 1e-300), "robot1: mass (kg) is 1e-300, allowed is 1e-06 to 1e+09");
  EXPECT_EQ(errorWith(&P::I_z, 1e-30), "robot1: inertia about z (kg m^2) is 1e-30, allowed is 1e-09 to 1e+12");
  EXPECT_EQ(errorWith(&P::l_f, 1e300), "robot1: wheelbase (m) is 1e+300, allowed is 0.001 to 100");
  EXPECT_EQ(errorWith(&P::v_min, 1.0), "robot1: v_min is 1, allowed are numbers up to 0");
  EXPECT_EQ(errorWith(&P::command_timeout, kNan), "robot1: command_timeout is nan, allowed are numbers greater than 0");
  EXPECT_EQ(simulation.cars().size(), 0u);
}

TEST(Simulation, CarThatRunsAwayEndsTheSimulationInsteadOfHangingIt)
{
  VehicleParameters parameters;
  parameters.m = 1e6;
  parameters.I_z = 1e-9;
  Simulation simulation(world());
  simulation.addCar(car("robot1"), parameters, {});
  const std::string message = messageOf([&] { drive(simulation, kRobot1, {2.0, 0.1}, 2.0); });
  EXPECT_EQ(message.rfind("robot1: would go ", 0), 0u) << message;
  EXPECT_NE(message.find(" m in a step of 0.001 s: no car has parameters like its own"), std::string::npos);
}

TEST(Simulation, StepOutOfRangeIsRefused)
{
  for (const double step : {0.0, -0.001, 0.05, kNan}) {
    SimulationOptions options;
    options.physics_step = step;
    EXPECT_NE(
      messageOf([&] { Simulation simulation(world(), options); }).find("physics_step (s) is"), std::string::npos);
  }
}

TEST(Simulation, StartThatIsNotFiniteIsRefused)
{
  Simulation simulation(world());
  EXPECT_EQ(
    messageOf([&] {
      simulation.addCar(car("robot1"), {}, {0, kNan, 0});
    }),
    "robot1: y (m) of the pose is nan, allowed is -100000 to 100000");
}

TEST(Simulation, StartBeyondTheWorldIsRefused)
{
  Simulation simulation(world());
  EXPECT_EQ(
    messageOf([&] {
      simulation.addCar(car("robot1"), {}, {1e9, 0, 0});
    }),
    "robot1: x (m) of the pose is 1e+09, allowed is -100000 to 100000");
}

TEST(Simulation, CarPlacedElsewhereStandsThereAndResetBringsItBack)
{
  Simulation simulation(world({room(3.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 0.5);
  simulation.placeCar(kRobot1, {-1.0, 0.5, 1.0});
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, -1.0, 1e-12);
  EXPECT_NEAR(simulation.state(kRobot1).pose.y, 0.5, 1e-12);
  EXPECT_NEAR(simulation.state(kRobot1).pose.yaw, 1.0, 1e-12);
  EXPECT_EQ(simulation.state(kRobot1).velocity.x, 0.0);
  simulation.reset();
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, 0.0, 1e-12);
}

TEST(Simulation, CarPlacedBesideAWallTouchesItAtOnce)
{
  Simulation simulation(world({room(3.0)}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.step();
  simulation.placeCar(kRobot1, {2.598, 0.0, 0.0});
  drive(simulation, kRobot1, {1.0, 0.0}, 0.2);
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_LT(simulation.state(kRobot1).pose.x, 2.605);
}

TEST(Simulation, CarIsNotPlacedWhereItDoesNotFit)
{
  Simulation simulation(world({room(3.0)}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {1, 0, 0});
  EXPECT_EQ(
    messageOf([&] {
      simulation.placeCar(kRobot1, {1.2, 0.1, 0});
    }),
    "robot1: the pose (1.2, 0.1, 0) is not free: it overlaps car robot2");
  EXPECT_EQ(
    messageOf([&] {
      simulation.placeCar(kRobot1, {1.2, kNan, 0});
    }),
    "robot1: y (m) of the pose is nan, allowed is -100000 to 100000");
  EXPECT_NEAR(simulation.state(kRobot1).pose.x, 0.0, 1e-12);
}

TEST(Simulation, TiltedLidarIsRefused)
{
  CarDescription description = car("robot1");
  description.lidars[0].pose = Pose3(0, 0, 0.1, 0, 0.25, 0);
  Simulation simulation(world());
  EXPECT_EQ(
    messageOf([&] { simulation.addCar(description, {}, {}); }),
    "robot1: lidar lidar: tilt (rad) is 0.25, allowed is 0: the scan plane must be level");
}

TEST(Simulation, MovableModelNeedsAMass)
{
  ModelDescription model = movableBox("crate", 0.2, 1, 0);
  model.mass = 0.0;
  EXPECT_EQ(
    messageOf([&] { Simulation simulation(world({model})); }),
    "test.world: model crate: mass (kg) is 0, allowed is 1e-06 to 1e+09");
}

TEST(Simulation, UnknownModelIsNamed)
{
  const Simulation simulation(world({room(3.0)}));
  EXPECT_EQ(messageOf([&] { simulation.modelPose("crate"); }), "there is no model crate in test.world");
  EXPECT_EQ(simulation.modelNames(), std::vector<std::string>{"walls"});
}

TEST(Simulation, TimeAdvancesInWholeSteps)
{
  Simulation simulation(world());
  EXPECT_EQ(simulation.stepLength(), 1'000'000);
  simulation.advanceTo(1'500'000);
  EXPECT_EQ(simulation.time(), 2'000'000);
  simulation.reset();
  EXPECT_EQ(simulation.time(), 0);
}

/// Two cars race about in a room with a crate until they have hit each other, the walls and the crate.
std::string hashOfRun(Simulation & simulation)
{
  TrajectoryHash hash;
  for (int i = 0; i < 4000; ++i) {
    simulation.command(kRobot1, {3.0, 0.3 * std::sin(0.001 * i)});
    simulation.commandTwist(kRobot2, i % 2000 < 1500 ? 2.0 : -1.5, 0.8);
    simulation.step();
    if (i % 25 == 24) {
      hash.add(simulation);
    }
  }
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_FALSE(simulation.contacts(kRobot2).empty());
  return hash.hexDigest();
}

Simulation busySimulation(std::uint64_t seed = 0)
{
  Simulation simulation(world({room(3.0), movableBox("crate", 0.3, 1.5, 0.2)}), {0.001, seed});
  simulation.addCar(car("robot1"), {}, {0, 0.3, 0});
  simulation.addCar(car("robot2"), {}, {0, -0.3, 0});
  return simulation;
}

TEST(Determinism, FreshRunsAndRunsAfterResetAreEqualToTheLastBit)
{
  Simulation first = busySimulation();
  Simulation second = busySimulation();
  const std::string hash = hashOfRun(first);
  EXPECT_EQ(hash.size(), 64u);
  EXPECT_EQ(hashOfRun(second), hash);
  first.reset();
  EXPECT_EQ(hashOfRun(first), hash);
}

TEST(Determinism, ResetBringsMovedModelsAndNoiseBack)
{
  Simulation simulation = busySimulation();
  std::vector<float> before(1081);
  std::vector<float> after(1081);
  simulation.scan(kRobot1, 0, before.data());
  hashOfRun(simulation);
  EXPECT_GT(std::abs(simulation.modelPose("crate").x - 1.5), 0.01);
  simulation.reset();
  EXPECT_EQ(simulation.modelPose("crate").x, 1.5);
  EXPECT_TRUE(simulation.contacts(kRobot1).empty());
  simulation.scan(kRobot1, 0, after.data());
  EXPECT_EQ(before, after);
}

TEST(Determinism, LookingChangesNothing)
{
  Simulation watched = busySimulation();
  Simulation unwatched = busySimulation();
  std::vector<float> ranges(1081);
  for (int i = 0; i < 2000; ++i) {
    for (Simulation * simulation : {&watched, &unwatched}) {
      simulation->command(kRobot1, {3.0, 0.1});
      simulation->step();
    }
    watched.scan(kRobot1, 0, ranges.data());
    watched.clearance(kRobot1, 5.0);
    watched.clearContacts(kRobot1);
  }
  EXPECT_EQ(watched.state(kRobot1).pose.x, unwatched.state(kRobot1).pose.x);
  EXPECT_EQ(watched.state(kRobot1).pose.yaw, unwatched.state(kRobot1).pose.yaw);
}

TEST(TrajectoryHash, DigestOfNothingIsThatOfSha256)
{
  TrajectoryHash hash;
  const std::string nothing = hash.hexDigest();
  EXPECT_EQ(nothing, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  hash.add(simulation);
  const std::string one = hash.hexDigest();
  EXPECT_NE(one, nothing);
  EXPECT_EQ(hash.hexDigest(), one);
  hash.reset();
  hash.add(simulation);
  EXPECT_EQ(hash.hexDigest(), one);
}

TEST(TrajectoryHash, StateIsSevenNumbersACar)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {3, 0, 0});
  std::vector<std::uint8_t> bytes;
  simulation.appendStateBytes(bytes);
  EXPECT_EQ(bytes.size(), 2u * 7u * 8u);
}
}  // namespace f1tenth_sim2d::test
