#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "sample_world.h"

// Cars and models come, go and are put elsewhere while the simulation runs.
namespace f1tenth_sim2d::test
{
namespace
{
std::string hashOfDrive(Simulation & simulation)
{
  TrajectoryHash hash;
  for (int i = 0; i < 40; ++i) {
    double steering_angle = 0.0;
    for (const CarId car : simulation.cars()) {
      simulation.command(car, {2.0, steering_angle});
      steering_angle += 0.1;
    }
    simulation.advanceTo(simulation.time() + 25000000);
    hash.add(simulation);
  }
  return hash.hexDigest();
}

float ahead(const Simulation & simulation)
{
  std::vector<float> ranges(1081);
  simulation.exactScan(kRobot1, 0, ranges.data());
  return ranges[540];
}

/// A scan, and where the car believes to be.
std::vector<double> noisyReadings(const Simulation & simulation, CarId car)
{
  std::vector<float> ranges(1081);
  simulation.scan(car, 0, ranges.data());
  std::vector<double> readings(ranges.begin(), ranges.end());
  const WheelOdometry odometry = simulation.wheelOdometry(car);
  readings.insert(readings.end(), {odometry.pose.x, odometry.pose.y, odometry.pose.yaw});
  return readings;
}

template <typename Action>
std::string errorOf(const Action & action)
{
  try {
    action();
  } catch (const Error & error) {
    return error.what();
  }
  return "";
}
}  // namespace

TEST(ChangingWorld, ResetAfterRemovingACarIsAsFresh)
{
  Simulation changed(world({room(5.0), movableBox("crate", 0.2, 1.0, 0.0)}));
  changed.addCar(car("robot1"), {}, {0.0, 1.0, 0.0});
  changed.addCar(car("robot2"), {}, {});
  hashOfDrive(changed);
  changed.removeCar(kRobot1);
  ASSERT_EQ(changed.cars(), std::vector<CarId>{kRobot2});
  EXPECT_EQ(changed.car(kRobot2).name, "robot2");
  changed.reset();
  Simulation fresh(world({room(5.0), movableBox("crate", 0.2, 1.0, 0.0)}));
  fresh.addCar(car("robot2"), {}, {});
  EXPECT_EQ(hashOfDrive(changed), hashOfDrive(fresh));
  EXPECT_EQ(changed.modelPose("crate").x, fresh.modelPose("crate").x);
}

TEST(ChangingWorld, IdOfACarStaysItsOwnWhenOthersComeAndGo)
{
  Simulation simulation(world());
  const CarId first = simulation.addCar(car("robot1"), {}, {});
  const CarId second = simulation.addCar(car("robot2"), {}, {0.0, 1.0, 0.0});
  simulation.removeCar(first);
  const CarId third = simulation.addCar(car("robot3"), {}, {0.0, 2.0, 0.0});
  EXPECT_EQ(simulation.cars(), (std::vector<CarId>{second, third}));
  EXPECT_EQ(simulation.car(second).name, "robot2");
  EXPECT_EQ(simulation.car(third).name, "robot3");
  EXPECT_EQ(simulation.state(third).pose.y, 2.0);
  EXPECT_NE(third, first);
  EXPECT_THROW(simulation.state(first), std::out_of_range);
}

TEST(ChangingWorld, UnknownCarIsNamed)
{
  const auto question = [](const Simulation & simulation) -> std::string {
    try {
      simulation.state(CarId{7});
    } catch (const std::out_of_range & error) {
      return error.what();
    }
    return "";
  };
  Simulation simulation(world());
  EXPECT_EQ(question(simulation), "there is no car 7");
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {0.0, 1.0, 0.0});
  EXPECT_EQ(question(simulation), "there is no car 7, only 0, 1");
}

TEST(ChangingWorld, CarKeepsItsNoiseWhenAnotherLeaves)
{
  const auto driven = [](bool remove) {
    Simulation simulation(world({room(30.0)}));
    simulation.addCar(car("robot1"), {}, {-20.0, 0.0, 0.0});
    simulation.addCar(car("robot2"), {}, {20.0, 0.0, 0.0});
    drive(simulation, kRobot2, {1.0, 0.1}, 0.5);
    if (remove) {
      simulation.removeCar(kRobot1);
    }
    drive(simulation, kRobot2, {1.0, 0.1}, 0.5);
    return noisyReadings(simulation, kRobot2);
  };
  EXPECT_EQ(driven(true), driven(false));
}

TEST(ChangingWorld, CarThatComesAgainHasTheNoiseThatItHad)
{
  const auto readings = [](Simulation & simulation, CarId car) {
    drive(simulation, car, {1.0, 0.1}, 0.5);
    return noisyReadings(simulation, car);
  };
  Simulation simulation(world({room(5.0)}));
  const CarId first = simulation.addCar(car("robot1"), {}, {});
  const auto before = readings(simulation, first);
  simulation.removeCar(first);
  simulation.reset();
  const CarId second = simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(readings(simulation, second), before);
}

TEST(ChangingWorld, OthersStayWhereTheyAreWhenACarLeaves)
{
  Simulation simulation(world({movableBox("crate", 0.2, 1.0, 0.0)}));
  simulation.addCar(car("robot1"), {}, {0.0, 2.0, 0.0});
  simulation.addCar(car("robot2"), {}, {});
  drive(simulation, kRobot2, {2.0, 0.0}, 0.8);
  const Pose2 pose = simulation.state(kRobot2).pose;
  const ModelState crate = simulation.modelState(0);
  simulation.removeCar(kRobot1);
  EXPECT_EQ(simulation.state(kRobot2).pose.x, pose.x);
  EXPECT_EQ(simulation.modelState(0).pose.x, crate.pose.x);
  EXPECT_EQ(simulation.modelState(0).velocity.x, crate.velocity.x);
  EXPECT_GT(crate.velocity.x, 0.1);
}

TEST(ChangingWorld, ModelThatIsAddedIsSeenAndFelt)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(ahead(simulation), std::numeric_limits<float>::infinity());
  simulation.addModel(wallAcross(2.0));
  EXPECT_NEAR(ahead(simulation), 2.0 - 0.27, 1e-4);
  drive(simulation, kRobot1, {3.0, 0.0}, 2.0);
  ASSERT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_model, "walls");
  EXPECT_LT(simulation.state(kRobot1).pose.x, 1.61);
}

TEST(ChangingWorld, ModelThatIsRemovedIsGoneAlsoAfterReset)
{
  Simulation simulation(world({wallAcross(2.0), movableBox("crate", 0.2, 1.0, 3.0)}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.removeModel(0);
  EXPECT_EQ(simulation.modelNames(), std::vector<std::string>{"crate"});
  EXPECT_EQ(ahead(simulation), std::numeric_limits<float>::infinity());
  simulation.reset();
  drive(simulation, kRobot1, {3.0, 0.0}, 2.0);
  EXPECT_TRUE(simulation.contacts(kRobot1).empty());
}

TEST(ChangingWorld, StaticModelIsMovedAndReturnsOnReset)
{
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.placeModel(0, {{1.0, 0.0, 0.0}, {}, 0.0});
  EXPECT_NEAR(ahead(simulation), 3.0 - 0.27, 1e-4);
  EXPECT_EQ(simulation.modelState(0).pose.x, 1.0);
  simulation.reset();
  EXPECT_NEAR(ahead(simulation), 2.0 - 0.27, 1e-4);
  EXPECT_EQ(simulation.modelState(0).pose.x, 0.0);
}

TEST(ChangingWorld, MovableModelMovesWithTheGivenTwistUntilFrictionStopsIt)
{
  Simulation simulation(world({movableBox("crate", 0.2, 5.0, 0.0)}));
  simulation.placeModel(0, {{0.0, 1.0, 0.5}, {2.0, -1.0}, 3.0});
  const ModelState start = simulation.modelState(0);
  EXPECT_NEAR(start.pose.y, 1.0, 1e-6);
  EXPECT_NEAR(start.velocity.x, 2.0, 1e-6);
  EXPECT_NEAR(start.yaw_rate, 3.0, 1e-6);
  simulation.advanceTo(100000000);
  EXPECT_GT(simulation.modelState(0).pose.x, 0.1);
  EXPECT_LT(simulation.modelState(0).velocity.x, 2.0);
  simulation.advanceTo(5000000000);
  EXPECT_EQ(simulation.modelState(0).velocity.x, 0.0);
}

TEST(ChangingWorld, CarIsPlacedWithATwist)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.placeCar(kRobot1, {1.0, 2.0, 0.3}, {3.0, 0.2}, 0.4);
  const CarState & state = simulation.state(kRobot1);
  EXPECT_NEAR(state.velocity.x, 3.0, 1e-12);
  EXPECT_NEAR(state.velocity.y, 0.2, 1e-12);
  EXPECT_NEAR(state.yaw_rate, 0.4, 1e-12);
}

TEST(ChangingWorld, RefusesWhatMakesNoSense)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Simulation simulation(world({wallAcross(2.0)}));
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(errorOf([&] { simulation.addModel(wallAcross(3.0)); }), "walls: there is already a model of this name");
  ModelDescription massless = movableBox("crate", 0.2, 0.0, 5.0);
  massless.mass = 0.0;
  EXPECT_EQ(
    errorOf([&] { simulation.addModel(massless); }),
    "test.world: model crate: mass (kg) is 0, allowed is 1e-06 to 1e+09");
  EXPECT_EQ(
    errorOf([&] {
      simulation.placeModel(0, {{nan, 0.0, 0.0}, {}, 0.0});
    }),
    "walls: x (m) is nan, allowed is -100000 to 100000");
  EXPECT_EQ(
    errorOf([&] {
      simulation.placeCar(kRobot1, {}, {nan, 0.0});
    }),
    "robot1: velocity in x (m/s) is nan, allowed is -1000 to 1000");
}

TEST(ChangingWorld, RefusesNamesThatARecordCannotHold)
{
  Simulation simulation(world());
  EXPECT_EQ(
    errorOf([&] { simulation.addCar(car("a,b"), {}, {}); }),
    "car: found the name 'a,b', allowed is one without , ; \" and control characters");
  EXPECT_EQ(
    errorOf([&] { simulation.addModel(movableBox("a\nb", 0.2, 0.0, 0.0)); }),
    "test.world: model: found the name 'a?b', allowed is one without , ; \" and control characters");
  for (const std::string name : {"a;b", "a\"b", "a\rb"}) {
    EXPECT_NE(errorOf([&] { Simulation refused(world({movableBox(name, 0.2, 0.0, 0.0)})); }), "") << name;
  }
  EXPECT_EQ(errorOf([&] { simulation.addModel(movableBox("m::box 1.2-x/y'z", 0.2, 0.0, 0.0)); }), "");
}

TEST(ChangingWorld, RefusesAbsurdMotionsOfModels)
{
  Simulation simulation(world({movableBox("crate", 0.4, 0.0, 0.0)}));
  EXPECT_EQ(
    errorOf([&] {
      simulation.placeModel(0, {{1e300, 0.0, 0.0}, {}, 0.0});
    }),
    "crate: x (m) is 1e+300, allowed is -100000 to 100000");
  EXPECT_EQ(
    errorOf([&] {
      simulation.placeModel(0, {{}, {0.0, -1e30}, 0.0});
    }),
    "crate: velocity in y (m/s) is -1e+30, allowed is -1000 to 1000");
  EXPECT_EQ(
    errorOf([&] {
      simulation.placeModel(0, {{}, {}, 1e9});
    }),
    "crate: yaw rate (rad/s) is 1e+09, allowed is -1000 to 1000");
}

TEST(ChangingWorld, RefusesAbsurdCommands)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  EXPECT_EQ(
    errorOf([&] {
      simulation.command(kRobot1, {101.0, 0.0});
    }),
    "robot1: commanded speed (m/s) is 101, allowed is -100 to 100");
  EXPECT_EQ(
    errorOf([&] {
      simulation.command(kRobot1, {1.0, 20.0});
    }),
    "robot1: commanded steering angle (rad) is 20, allowed is -6.2832 to 6.2832");
  EXPECT_EQ(
    errorOf([&] { simulation.commandTwist(kRobot1, 1.0, 1e9); }),
    "robot1: commanded yaw rate (rad/s) is 1e+09, allowed is -1000 to 1000");
  EXPECT_NE(errorOf([&] { simulation.commandTwist(kRobot1, -1e300, 0.0); }), "");
  drive(simulation, kRobot1, {0.0, 0.0}, 0.5);
  EXPECT_EQ(simulation.state(kRobot1).velocity.x, 0.0);
}
}  // namespace f1tenth_sim2d::test
