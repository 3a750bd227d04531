#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "sample_world.h"

// Box2D is spared cars that are far from everything: that changes no bit of what one car does, nor of what several do until they
// touch something. Afterwards it may solve their contacts in another order.
namespace f1tenth_sim2d::test
{
namespace
{
using Bytes = std::vector<std::uint8_t>;

/// A room with crates and cars at random places; they take short cuts into walls, crates and each other.
class Mayhem
{
public:
  Mayhem(unsigned seed, std::size_t cars) : random_(seed)
  {
    description_ = world({room(number(2.0, 4.0))});
    for (int i = 0; i < 4; ++i) {
      description_.models.push_back(movableBox("crate" + std::to_string(i), 0.2, 0.9 + 0.3 * i, number(-1.8, 1.8)));
    }
    for (std::size_t i = 0; i < cars; ++i) {
      starts_.push_back({-0.5 - 0.6 * static_cast<double>(i), number(-1.5, 1.5), number(-0.3, 0.3)});
    }
    for (int i = 0; i < 60 * static_cast<int>(cars); ++i) {
      commands_.push_back({number(-2.0, 6.0), number(-0.4, 0.4)});
    }
  }

  /// States of cars and models after each step, with several cars only before the first contact, and whether anything touched.
  std::pair<Bytes, bool> states(bool spares_far_cars) const
  {
    SimulationOptions options;
    options.spares_far_cars = spares_far_cars;
    Simulation simulation(description_, options);
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      simulation.addCar(car("robot" + std::to_string(i + 1)), {}, starts_[i]);
    }
    Bytes bytes;
    bool touched = false;
    for (std::size_t step = 0; step < 50 * commands_.size() / starts_.size(); ++step) {
      for (std::size_t i = 0; i < starts_.size(); ++i) {
        simulation.command(simulation.cars()[i], commands_[step / 50 * starts_.size() + i]);
      }
      simulation.step();
      for (const CarId each : simulation.cars()) {
        touched |= !simulation.contacts(each).empty();
      }
      if (touched && starts_.size() > 1) {
        break;
      }
      simulation.appendStateBytes(bytes);
      for (std::size_t model = 1; model < simulation.models().size(); ++model) {
        const ModelState state = simulation.modelState(model);
        const auto * const first = reinterpret_cast<const std::uint8_t *>(&state);
        bytes.insert(bytes.end(), first, first + sizeof(state));
      }
    }
    return {bytes, touched};
  }

private:
  double number(double least, double greatest) { return std::uniform_real_distribution(least, greatest)(random_); }

  std::mt19937 random_;
  WorldDescription description_;
  std::vector<Pose2> starts_;
  std::vector<DriveCommand> commands_;
};

void expectNoDifference(unsigned seed, std::size_t cars, int & touching)
{
  const Mayhem mayhem(seed, cars);
  const auto [spared, touched] = mayhem.states(true);
  EXPECT_EQ(spared, mayhem.states(false).first) << "seed " << seed << ", cars " << cars;
  touching += touched ? 1 : 0;
}
}  // namespace

TEST(FarCars, StatesAreThoseOfSteppingBox2dThroughout)
{
  int touching = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    expectNoDifference(seed, 1, touching);
    expectNoDifference(seed, 2, touching);
  }
  EXPECT_GT(touching, 20);
}
}  // namespace f1tenth_sim2d::test
