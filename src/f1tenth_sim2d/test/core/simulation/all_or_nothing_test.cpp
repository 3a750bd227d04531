#include <gtest/gtest.h>

#include <new>
#include <string>

#include "allocation_count.h"
#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "sample_world.h"

// What cannot be added leaves no trace, wherever it failed.
namespace f1tenth_sim2d::test
{
namespace
{
ModelDescription ball(const std::string & name, bool is_static, double x, double y)
{
  ModelDescription model = movableBox(name, 0.2, x, y);
  model.is_static = is_static;
  model.solids[0].shape = Sphere{0.1};
  model.solids[0].pose = Pose3(0, 0, 0.1, 0, 0, 0);
  return model;
}

WorldDescription playground()
{
  return world({room(3.0), ball("ball", false, 1.0, 0.1), ball("bollard", true, 1.6, -0.2)});
}

/// Touches a ball in another layer than the other cars, and looks at another height.
CarDescription lowCar()
{
  CarDescription description = car("robot2");
  description.solids[1].pose.position.z() = 0.05;
  description.lidars[0].pose.position.z() = 0.2;
  description.lidars.push_back(lidar());
  return description;
}

const Pose2 kFree{1.6, 1.0, -1.5708};  // above the bollard, heading for it
const Pose2 kOccupied{0.1, 0.0, 0.0};

Simulation started()
{
  Simulation simulation(playground());
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {2.0, 0.0}, 0.4);
  return simulation;
}

/// Both cars push the balls about.
std::string hashOfPlaying(Simulation & simulation)
{
  simulation.addCar(lowCar(), {}, kFree);
  TrajectoryHash hash;
  for (int i = 0; i < 40; ++i) {
    simulation.command(kRobot1, {2.0, 0.05});
    simulation.command(kRobot2, {2.0, 0.0});
    simulation.advanceTo(simulation.time() + 25'000'000);
    hash.add(simulation);
  }
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_FALSE(simulation.contacts(kRobot2).empty());
  return hash.hexDigest();
}

std::string hashOfPlaying()
{
  Simulation simulation = started();
  return hashOfPlaying(simulation);
}

/// Lets every allocation of an action fail, one after the other, each time with a simulation of its own.
/// @return how many there were
template <typename Action, typename Check>
std::size_t failEachAllocation(Action action, Check check)
{
  for (std::size_t number = 1;; ++number) {
    Simulation simulation = started();
    failAllocation(number);
    try {
      action(simulation);
      failAllocation(0);
      return number - 1;
    } catch (const std::bad_alloc &) {
      failAllocation(0);
      check(simulation);
      if (::testing::Test::HasFailure()) {
        return number;
      }
    }
  }
}
}  // namespace

TEST(AllOrNothing, CarThatMemoryDoesNotSufficeForLeavesNoTrace)
{
  const std::string expected = hashOfPlaying();
  const CarDescription low = lowCar();
  const std::size_t count = failEachAllocation(
    [&](Simulation & simulation) { simulation.addCar(low, {}, kFree); },
    [&](Simulation & simulation) {
      EXPECT_EQ(simulation.cars(), std::vector<CarId>{kRobot1});
      EXPECT_EQ(hashOfPlaying(simulation), expected);
    });
  EXPECT_GT(count, 50u);
}

TEST(AllOrNothing, CarWhosePlaceIsNotFreeLeavesNoTrace)
{
  Simulation simulation = started();
  EXPECT_THROW(simulation.addCar(lowCar(), {}, kOccupied), Error);
  EXPECT_EQ(hashOfPlaying(simulation), hashOfPlaying());
}

TEST(AllOrNothing, ModelThatMemoryDoesNotSufficeForLeavesNoTrace)
{
  const std::string expected = hashOfPlaying();
  const ModelDescription second = ball("second", false, -1.0, 0.0);
  const std::size_t count = failEachAllocation(
    [&](Simulation & simulation) { simulation.addModel(second); },
    [&](Simulation & simulation) {
      EXPECT_EQ(simulation.modelNames(), (std::vector<std::string>{"walls", "ball", "bollard"}));
      EXPECT_EQ(hashOfPlaying(simulation), expected);
    });
  EXPECT_GT(count, 50u);
}

TEST(AllOrNothing, CarThatMemoryDoesNotSufficeToRemoveStays)
{
  const std::string expected = hashOfPlaying();
  failEachAllocation(
    [&](Simulation & simulation) { simulation.removeCar(kRobot1); },
    [&](Simulation & simulation) {
      EXPECT_EQ(simulation.cars(), std::vector<CarId>{kRobot1});
      EXPECT_EQ(hashOfPlaying(simulation), expected);
    });
}
}  // namespace f1tenth_sim2d::test
