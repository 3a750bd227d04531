#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/trajectory_hash.h"
#include "sample_world.h"

// Simulations that share one world, also on several threads.
namespace f1tenth_sim2d::test
{
namespace
{
PreparedWorld roomWithCrate()
{
  return PreparedWorld(world({room(3.0), movableBox("crate", 0.2, 1.0, 0.1)}));
}

/// A car looks around and pushes the crate into a wall.
std::string hashOfPushing(Simulation & simulation)
{
  simulation.addCar(car("robot1"), {}, {});
  std::vector<float> ranges(1081);
  TrajectoryHash hash;
  for (int i = 0; i < 80; ++i) {
    simulation.scan(kRobot1, 0, ranges.data());
    simulation.command(kRobot1, {2.0, ranges[300] < ranges[780] ? 0.1 : -0.1});
    simulation.advanceTo(simulation.time() + 25'000'000);
    hash.add(simulation);
  }
  return hash.hexDigest();
}

std::string hashAlone()
{
  Simulation simulation(world({room(3.0), movableBox("crate", 0.2, 1.0, 0.1)}));
  return hashOfPushing(simulation);
}
}  // namespace

TEST(SharedWorld, SimulationsInOneWorldDoNotNoticeEachOther)
{
  const PreparedWorld shared = roomWithCrate();
  Simulation first(shared);
  Simulation second(shared);
  const std::string alone = hashAlone();
  EXPECT_EQ(hashOfPushing(first), alone);
  EXPECT_EQ(hashOfPushing(second), alone);
}

TEST(SharedWorld, EachLidarHasItsOwnBeamsAndRange)
{
  const PreparedWorld shared = roomWithCrate();
  CarDescription short_sighted = car("robot1");
  short_sighted.lidars.front().range_max = 2.0;
  CarDescription coarse = car("robot1");
  coarse.lidars.front().beam_count = 3;
  const auto look = [&](const CarDescription & description) {
    Simulation simulation(shared);
    simulation.addCar(description, {}, {0.0, 0.0, M_PI});
    std::vector<float> ranges(static_cast<std::size_t>(description.lidars.front().beam_count));
    simulation.exactScan(kRobot1, 0, ranges.data());
    return ranges;
  };
  const std::vector<float> all = look(car("robot1"));
  const std::vector<float> three = look(coarse);
  EXPECT_EQ(three, (std::vector<float>{all.front(), all[540], all.back()}));
  EXPECT_GT(all[540], 2.0F);
  EXPECT_EQ(look(short_sighted)[540], INFINITY);
}

TEST(SharedWorld, SimulationThatChangesItsModelsChangesNoOther)
{
  const PreparedWorld shared = roomWithCrate();
  Simulation changed(shared);
  Simulation other(shared);
  changed.removeModel(0);
  changed.addModel(wallAcross(5.0));
  EXPECT_EQ(other.modelNames(), (std::vector<std::string>{"walls", "crate"}));
  EXPECT_EQ(shared.description().models.size(), 2u);
  EXPECT_EQ(hashOfPushing(other), hashAlone());
}

TEST(SharedWorld, LivesAsLongAsASimulationInIt)
{
  Simulation simulation = [] { return Simulation(roomWithCrate()); }();
  EXPECT_EQ(hashOfPushing(simulation), hashAlone());
}

TEST(SharedWorld, IsRefusedWhenNoSimulationCouldBeBuiltFromIt)
{
  ModelDescription massless = movableBox("crate", 0.2, 1.0, 0.0);
  massless.mass = 0.0;
  EXPECT_THROW(PreparedWorld(world({massless})), Error);
}

TEST(SharedWorld, SimulationsOnSeveralThreadsAreTheSameAsAlone)
{
  const PreparedWorld shared = roomWithCrate();
  const std::string alone = hashAlone();
  std::vector<std::string> hashes(4);
  std::vector<std::thread> threads;
  threads.reserve(hashes.size());
  for (std::string & hash : hashes) {
    threads.emplace_back([&] {
      Simulation simulation(shared);
      hash = hashOfPushing(simulation);
    });
  }
  for (std::thread & thread : threads) {
    thread.join();
  }
  EXPECT_EQ(hashes, std::vector<std::string>(4, alone));
}

TEST(SharedWorld, SeveralThreadsLookAroundInOneSimulation)
{
  Simulation simulation(roomWithCrate());
  simulation.addCar(car("robot1"), {}, {});
  simulation.addCar(car("robot2"), {}, {0.0, 1.0, 0.0});
  const auto look = [&](CarId own) {
    std::vector<float> ranges(1081);
    simulation.scan(own, 0, ranges.data());
    return ranges;
  };
  const std::vector<float> expected[]{look(kRobot1), look(kRobot2)};
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    threads.emplace_back([&, i] {
      for (int scan = 0; scan < 100; ++scan) {
        const std::size_t own = (i + static_cast<std::size_t>(scan)) % 2;
        wrong[i] += look(own == 0 ? kRobot1 : kRobot2) == expected[own] ? 0 : 1;
        wrong[i] += simulation.state(kRobot1).pose.x == 0.0 ? 0 : 1;
        double range = 0.0;
        simulation.castRays(kRobot1, {{}, 0.01 * (1 + scan % 7), {M_PI}, 10.0}, &range);
        wrong[i] += std::abs(range - 3.0) < 1e-9 ? 0 : 1;
      }
    });
  }
  for (std::thread & thread : threads) {
    thread.join();
  }
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}
}  // namespace f1tenth_sim2d::test
