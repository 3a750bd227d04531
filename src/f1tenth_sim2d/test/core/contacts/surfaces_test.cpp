// What two surfaces make of each other: the smaller coefficient of the two counts, as in Gazebo with ODE.
#include <gtest/gtest.h>

#include "sample_world.h"

namespace f1tenth_sim2d::test
{
struct Pair
{
  double car;
  double thing;
};

CarDescription carOf(double mu, double restitution)
{
  CarDescription description = car("robot1");
  for (Solid & solid : description.solids) {
    solid.mu = mu;
    solid.restitution = restitution;
  }
  return description;
}

/// How fast a wall throws a car back that drives against it with 2 m/s and is left to itself.
double rebound(const Pair & restitution)
{
  ModelDescription wall = wallAcross(2.0);
  wall.solids[0].restitution = restitution.thing;
  Simulation simulation(world({wall}));
  VehicleParameters parameters;
  parameters.actuation_latency = 0.0;
  simulation.addCar(carOf(1.0, restitution.car), parameters, {});
  while (simulation.contacts(kRobot1).empty() && simulation.time() < 5'000'000'000) {
    simulation.command(kRobot1, {2.0, 0.0});
    simulation.step();
  }
  return -simulation.state(kRobot1).velocity.x;
}

/// How far a car gets along a wall that it drives against with a slant, m.
double slide(const Pair & mu)
{
  Solid wall = box("walls::Wall_0::c", 40, 0.15, 2.5, 20, 0.7, 1.25);
  wall.mu = mu.thing;
  Simulation simulation(world({staticModel("walls", wall)}));
  simulation.addCar(carOf(mu.car, 0.0), {}, {0, 0.4, 0.05});
  drive(simulation, kRobot1, {2.0, 0.1}, 3.0);
  return simulation.state(kRobot1).pose.x;
}

TEST(Surfaces, OneThatDoesNotSpringBackDecides)
{
  const double springy = rebound({0.8, 0.8});
  EXPECT_NEAR(springy, 1.6, 0.1);
  EXPECT_NEAR(rebound({0.0, 0.8}), 0.0, 0.02);
  EXPECT_NEAR(rebound({0.8, 0.0}), 0.0, 0.02);
  EXPECT_DOUBLE_EQ(rebound({0.3, 0.8}), rebound({0.8, 0.3}));
}

TEST(Surfaces, SlipperyOneDecides)
{
  const double slippery = slide({0.05, 0.05});
  EXPECT_GT(slippery, slide({0.9, 0.9}) + 0.2);
  EXPECT_DOUBLE_EQ(slide({0.9, 0.05}), slippery);
  EXPECT_DOUBLE_EQ(slide({0.05, 0.9}), slippery);
}
}  // namespace f1tenth_sim2d::test
