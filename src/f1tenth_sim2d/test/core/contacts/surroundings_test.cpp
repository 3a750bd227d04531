#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/contacts/piece_set.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "sample_world.h"

// Only the walls that something comes near are given to Box2D.
namespace f1tenth_sim2d::test
{
namespace
{
Piece square(float x, float y)
{
  Piece piece{};
  b2PolygonShape shape;
  shape.SetAsBox(1.0F, 1.0F, {x, y}, 0.0F);
  piece.shape = shape;
  return piece;
}

std::vector<std::size_t> found(const PieceSet & pieces, const b2AABB & region)
{
  std::vector<std::size_t> indices;
  pieces.forEachFixedIn(region, [&](std::size_t index, const Piece &) { indices.push_back(index); });
  return indices;
}

/// A corridor along the x axis, 2 m wide, its walls in sections of 1 m.
ModelDescription corridor(int sections)
{
  ModelDescription model;
  model.name = "walls";
  model.is_static = true;
  for (int i = 0; i < sections; ++i) {
    for (const double y : {-1.05, 1.05}) {
      const std::string name = "walls::Wall_" + std::to_string(model.solids.size()) + "::c";
      model.solids.push_back(box(name, 1.0, 0.1, 2.5, i, y, 1.25));
    }
  }
  return model;
}

std::string hashOfScraping(Simulation & simulation)
{
  TrajectoryHash hash;
  for (int i = 0; i < 400; ++i) {
    simulation.command(kRobot1, {4.0, i % 100 < 50 ? 0.1 : -0.1});
    simulation.advanceTo(simulation.time() + 25'000'000);
    hash.add(simulation);
  }
  return hash.hexDigest();
}
}  // namespace

TEST(PieceSet, FixedOnesInARegionAreFound)
{
  const PieceSet pieces(Layer::kWholeSolid, {}, {square(0.0F, 0.0F), square(100.0F, 0.0F)});
  EXPECT_EQ(pieces.fixedCount(), 2u);
  EXPECT_EQ(found(pieces, {{-2.0F, -2.0F}, {2.0F, 2.0F}}), std::vector<std::size_t>{0});
  EXPECT_EQ(found(pieces, {{98.0F, -2.0F}, {98.95F, 2.0F}}), std::vector<std::size_t>{1});
  EXPECT_TRUE(found(pieces, {{40.0F, 0.0F}, {60.0F, 1.0F}}).empty());
  EXPECT_EQ(found(pieces, {{-2.0F, -2.0F}, {200.0F, 2.0F}}).size(), 2u);
}

TEST(Surroundings, CarThatHasTouchedAWallIsStoppedByOneFarFromIt)
{
  Simulation simulation(world({wallAcross(50.0)}));
  simulation.addModel(staticModel("behind", box("behind::link::c", 0.1, 2.0, 2.5, -0.5, 0.0, 1.25)));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {-1.0, 0.0}, 1.0);
  ASSERT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_EQ(simulation.contacts(kRobot1)[0].other_model, "behind");
  drive(simulation, kRobot1, {8.0, 0.0}, 10.0);
  EXPECT_GT(simulation.state(kRobot1).pose.x, 49.5);
  EXPECT_LT(simulation.state(kRobot1).pose.x, 49.61);
}

TEST(Surroundings, MovableModelIsStoppedByWallsFarFromItsStart)
{
  ModelDescription crate = movableBox("crate", 0.2, 0.0, 0.0);
  crate.solids[0].mu = 0.1;
  Simulation simulation(world({crate, wallAcross(10.0)}));
  simulation.placeModel(0, {{0.0, 0.0, 0.0}, {12.0, 0.0}, 0.0});
  double farthest = 0.0;
  while (simulation.time() < 3'000'000'000) {
    simulation.step();
    farthest = std::max(farthest, simulation.modelPose("crate").x);
  }
  EXPECT_GT(farthest, 9.85);
  EXPECT_LT(farthest, 9.91);
}

TEST(Surroundings, StruckModelIsStoppedByTheWallBehindIt)
{
  Simulation simulation(world({movableBox("crate", 0.2, 3.0, 0.0), wallAcross(3.105)}));
  simulation.addCar(car("robot1"), {}, {});
  drive(simulation, kRobot1, {8.0, 0.0}, 2.0);
  EXPECT_FALSE(simulation.contacts(kRobot1).empty());
  EXPECT_LT(simulation.modelPose("crate").x, 3.02);
}

TEST(Surroundings, RunAlongManyWallsIsTheSameAfterAReset)
{
  const auto simulationOfCorridor = [] {
    Simulation simulation(world({corridor(60), movableBox("crate", 0.2, 8.0, 0.6)}));
    simulation.addCar(car("robot1"), {}, {});
    return simulation;
  };
  Simulation fresh = simulationOfCorridor();
  const std::string expected = hashOfScraping(fresh);
  EXPECT_FALSE(fresh.contacts(kRobot1).empty());
  Simulation again = simulationOfCorridor();
  drive(again, kRobot1, {5.0, -0.03}, 5.0);
  EXPECT_FALSE(again.contacts(kRobot1).empty());
  again.reset();
  EXPECT_EQ(hashOfScraping(again), expected);
  again.reset();
  EXPECT_EQ(hashOfScraping(again), expected);
}
}  // namespace f1tenth_sim2d::test
