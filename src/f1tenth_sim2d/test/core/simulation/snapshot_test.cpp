#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/simulation.h"
#include "sample_world.h"

// Going back to a moment of a simulation.
namespace f1tenth_sim2d::test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

/// A room with crates at random places and two cars that drive about, into walls, crates and each other.
class Brawl
{
public:
  explicit Brawl(unsigned seed) : random_(seed), simulation_(world(models()), {0.001, seed})
  {
    simulation_.addCar(car("robot1"), {}, {0.0, 0.0, 0.0});
    simulation_.addCar(car("robot2"), {}, {0.0, 0.8, 3.0});
  }

  Simulation & simulation() { return simulation_; }
  double number(double least, double greatest) { return std::uniform_real_distribution(least, greatest)(random_); }

private:
  std::vector<ModelDescription> models()
  {
    std::vector<ModelDescription> all{room(2.0)};
    for (int i = 0; i < 3; ++i) {
      all.push_back(movableBox("crate" + std::to_string(i), 0.2, 1.0 + 0.3 * i, number(-1.5, 1.5)));
    }
    return all;
  }

  std::mt19937 random_;
  Simulation simulation_;
};

/// Everything that can be seen of a simulation, step by step, while it is driven.
Bytes drivenOn(Simulation & simulation, double steering, int steps)
{
  Bytes seen;
  const auto add = [&](const auto & value) {
    const auto * const first = reinterpret_cast<const std::uint8_t *>(&value);
    seen.insert(seen.end(), first, first + sizeof(value));
  };
  std::vector<float> ranges(1081);
  for (int i = 0; i < steps; ++i) {
    simulation.command(kRobot1, {3.0, steering});
    simulation.command(kRobot2, {-2.0, 0.3});
    simulation.step();
    simulation.appendStateBytes(seen);
    add(simulation.wheelOdometry(kRobot1).pose.x);
    for (std::size_t model = 1; model < simulation.models().size(); ++model) {
      add(simulation.modelState(model).pose.x);
      add(simulation.modelState(model).yaw_rate);
    }
  }
  simulation.scan(kRobot1, 0, ranges.data());
  for (const float range : ranges) {
    add(range);
  }
  add(simulation.contacts(kRobot1).size());
  return seen;
}

struct Idle : Component
{
  Idle() : Component(Mount{"idle", "", "", {}, 0.0}) {}
};
}  // namespace

TEST(Snapshot, EverySimulationMadeFromItGoesOnAsTheFirst)
{
  int with_contacts = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Brawl brawl(seed);
    drivenOn(brawl.simulation(), brawl.number(-0.4, 0.4), 200 + static_cast<int>(brawl.number(0.0, 800.0)));
    brawl.simulation().clearContacts(kRobot1);
    const Simulation::Snapshot snapshot = brawl.simulation().snapshot();
    const double steering = brawl.number(-0.4, 0.4);
    const Bytes first = drivenOn(brawl.simulation(), steering, 400);
    Simulation again(snapshot);
    EXPECT_EQ(drivenOn(again, steering, 400), first) << seed;
    Simulation elsewhere(snapshot);
    EXPECT_NE(drivenOn(elsewhere, -steering, 400), first) << seed;
    Simulation last(snapshot);
    EXPECT_EQ(drivenOn(last, steering, 400), first) << seed;
    with_contacts += again.contacts(kRobot1).empty() ? 0 : 1;
  }
  EXPECT_GT(with_contacts, 5);
}

TEST(Snapshot, ChangesNothingWhileNothingTouches)
{
  Simulation one(world({room(30.0), movableBox("crate", 0.2, 1.0, 10.0)}));
  Simulation other(world({room(30.0), movableBox("crate", 0.2, 1.0, 10.0)}));
  for (Simulation * each : {&one, &other}) {
    each->addCar(car("robot1"), {}, {0.0, 0.0, 0.0});
    each->addCar(car("robot2"), {}, {0.0, 3.0, 0.0});
  }
  for (int i = 0; i < 5; ++i) {
    static_cast<void>(one.snapshot());
    EXPECT_EQ(drivenOn(one, 0.2, 100), drivenOn(other, 0.2, 100));
  }
}

TEST(Snapshot, OutlivesItsSimulationAndTakesPlacedModelsAlong)
{
  auto first = std::make_unique<Simulation>(world({room(3.0), movableBox("crate", 0.2, 1.0, 0.0)}));
  first->addCar(car("robot1"), {}, {0.0, 0.0, 0.0});
  first->placeModel(1, {{1.2345678, 0.5, 0.1}, {}, 0.0});
  const Pose2 placed = first->modelPose("crate");
  const Simulation::Snapshot snapshot = first->snapshot();
  first.reset();
  Simulation second(snapshot);
  EXPECT_EQ(second.modelPose("crate").x, placed.x);
  second.reset();
  EXPECT_EQ(second.modelPose("crate").x, 1.0);
}

TEST(Snapshot, ModelsThatNeverMovedStandWhereTheirFileSays)
{
  Simulation first(world({movableBox("moved", 0.2, 1.1, 0.0), movableBox("still", 0.2, 5.1, 0.0)}));
  first.addCar(car("robot1"), {}, {0.0, 0.0, 0.0});
  drive(first, kRobot1, {2.0, 0.0}, 1.0);
  ASSERT_GT(first.modelPose("moved").x, 1.11);
  const Simulation second(first.snapshot());
  EXPECT_EQ(second.modelPose("still").x, 5.1);
  EXPECT_EQ(second.modelPose("moved").x, first.modelPose("moved").x);
}

TEST(Snapshot, RefusesComponentsThatCannotBeCopied)
{
  Simulation simulation(world({}));
  simulation.addCar(car("robot1"), {}, {});
  simulation.mount(kRobot1, std::make_shared<Idle>());
  try {
    simulation.snapshot();
    FAIL() << "was not refused";
  } catch (const Error & error) {
    EXPECT_STREQ(error.what(), "robot1: the component idle cannot be copied");
  }
}
}  // namespace f1tenth_sim2d::test
