#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sample_world.h"

// How fast things meet.
namespace f1tenth_sim2d::test
{
namespace
{
double contactSpeed(const Simulation & simulation, CarId car)
{
  double greatest = 0.0;
  for (const Contact & contact : simulation.contacts(car)) {
    greatest = std::max(greatest, contact.speed);
  }
  return greatest;
}

/// A box of 5 kg that slides on ice.
ModelDescription slidingBox()
{
  ModelDescription model = movableBox("crate", 0.4, 3.0, 0.0);
  model.mass = 5.0;
  model.solids[0].mu = 0.0;
  return model;
}
}  // namespace

TEST(ContactSpeed, OfACarThatDrivesIntoAWallIsItsOwn)
{
  Simulation simulation(world({wallAcross(3.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {3.0, 0.0}, 2.0);
  EXPECT_NEAR(contactSpeed(simulation, kRobot1), 3.0, 0.05);
  EXPECT_NEAR(simulation.state(kRobot1).velocity.x, 0.0, 0.05) << "not what is left of it after the impact";
}

TEST(ContactSpeed, OfABoxThatStrikesAStandingCarIsThatOfTheBox)
{
  Simulation simulation(world({slidingBox()}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.placeModel(0, {{3.0, 0.0, 0.0}, {-6.0, 0.0}, 0.0});
  simulation.advanceTo(1'000'000'000);
  EXPECT_NEAR(contactSpeed(simulation, kRobot1), 6.0, 0.05);
}

TEST(ContactSpeed, OfTwoCarsIsHowFastTheyApproach)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {8.0, 0.0, M_PI});
  while (simulation.contacts(kRobot1).empty() && simulation.time() < 5'000'000'000) {
    simulation.command(kRobot1, {3.0, 0.0});
    simulation.command(kRobot2, {2.0, 0.0});
    simulation.step();
  }
  EXPECT_NEAR(contactSpeed(simulation, kRobot1), 5.0, 0.05);
  EXPECT_EQ(contactSpeed(simulation, kRobot2), contactSpeed(simulation, kRobot1));
}

TEST(ContactSpeed, OfACarThatRunsIntoAFasterOneFromBehindIsTheDifference)
{
  Simulation simulation(world());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {1.0, 0.0, 0.0});
  while (simulation.contacts(kRobot1).empty() && simulation.time() < 5'000'000'000) {
    simulation.command(kRobot1, {4.0, 0.0});
    simulation.command(kRobot2, {2.5, 0.0});
    simulation.step();
  }
  EXPECT_NEAR(contactSpeed(simulation, kRobot1), 1.5, 0.05);
}

TEST(ContactSpeed, OfACarThatGrazesAWallIsItsOwn)
{
  Simulation simulation(world({staticModel("wall", box("wall::link::c", 40, 0.2, 1.0, 20, 0.4, 0.5))}));
  simulation.addCar(car("robot1"), {}, {0.0, 0.0, 0.1});
  double before = 0.0;
  while (simulation.contacts(kRobot1).empty() && simulation.time() < 5'000'000'000) {
    before = simulation.state(kRobot1).velocity.x;
    simulation.command(kRobot1, {3.0, 0.0});
    simulation.step();
  }
  EXPECT_GT(before, 1.0);
  EXPECT_NEAR(contactSpeed(simulation, kRobot1), before, 0.02);
}

TEST(ContactSpeed, OfACarThatLeansAgainstAWallIsNothing)
{
  Simulation simulation(world({wallAcross(1.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {1.0, 0.0}, 2.0);
  simulation.clearContacts(kRobot1);
  drive(simulation, kRobot1, {1.0, 0.0}, 0.1);
  ASSERT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_LT(contactSpeed(simulation, kRobot1), 0.02);
}

TEST(ContactSpeed, StaysTheGreatestUntilContactsAreCleared)
{
  Simulation simulation(world({wallAcross(3.0)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {3.0, 0.0}, 4.0);
  EXPECT_NEAR(contactSpeed(simulation, kRobot1), 3.0, 0.05);
}
}  // namespace f1tenth_sim2d::test
