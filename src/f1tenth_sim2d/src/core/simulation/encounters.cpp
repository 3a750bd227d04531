#include "core/simulation/encounters.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kNear = 0.02;       // m, from where on a car takes part
constexpr double kLookAhead = 1.0;   // m, farther away need not be told apart
constexpr int kStepsNear = 10;       // after which a near car looks again
constexpr double kTravelMax = 10.0;  // m in a step, beyond which numbers have run away

double checkedTravel(const Car & car, double dt)
{
  const double travel = car.predictedTravel();
  if (!(travel <= kTravelMax)) {
    std::ostringstream message;
    message << car.description().name << ": would go " << travel << " m in a step of " << dt
            << " s: no car has parameters like its own";
    throw Error(message.str());
  }
  return travel;
}
}  // namespace

std::vector<PlacedCar> placedCars(const Cars & cars)
{
  std::vector<PlacedCar> placed;
  placed.reserve(cars.size());
  for (const auto & car : cars) {
    placed.push_back(car->placed());
  }
  return placed;
}

void Encounters::restart()
{
  std::fill(cars_.begin(), cars_.end(), Surroundings{});
}

bool Encounters::advance(const Cars & cars, CollisionWorld & world, double dt)
{
  const double travel = std::min(update(cars, world, dt), kTravelMax);
  const bool any_near = std::any_of(cars_.begin(), cars_.end(), [](const auto & car) { return car.is_near; });
  if (!any_near && !world.isAwake()) {
    return false;
  }
  for (std::size_t i = 0; i < cars.size(); ++i) {
    if (cars_[i].is_near) {
      world.place(i, cars[i]->predictedMotion());
    } else {
      world.remove(i);
    }
  }
  world.step(dt, travel);
  // A model that was struck in this step moved, though it stood still before.
  const double struck = world.movableTravel(dt);
  for (std::size_t i = 0; i < cars.size(); ++i) {
    cars_[i].free -= struck;
    if (cars_[i].is_near && !world.contacts(i).empty()) {
      cars[i]->apply(world.effect(i));
    }
  }
  return true;
}

// Returns the farthest that anything which takes part goes in this step.
double Encounters::update(const Cars & cars, const CollisionWorld & world, double dt)
{
  const double movable_travel = world.movableTravel(dt);
  double car_travel = 0.0;
  for (const auto & car : cars) {
    car_travel = std::max(car_travel, checkedTravel(*car, dt));
  }
  const double others = std::max(movable_travel, cars.size() > 1 ? car_travel : 0.0);
  double near_travel = movable_travel;
  for (std::size_t i = 0; i < cars.size(); ++i) {
    const double own = cars[i]->predictedTravel();
    look(cars, world, i, own + others);
    if (cars_[i].is_near) {
      near_travel = std::max(near_travel, own);
    }
  }
  return near_travel;
}

void Encounters::look(const Cars & cars, const CollisionWorld & world, std::size_t car, double approach)
{
  Surroundings & around = cars_[car];
  if (around.steps_left > 0) {
    --around.steps_left;
    return;
  }
  around.free -= approach;
  around.is_near = around.free <= kNear;
  if (around.is_near) {
    around.free = clearance(placedCars(cars), car, world, kLookAhead) - approach;
    around.is_near = around.free <= kNear;
    around.steps_left = around.is_near ? kStepsNear : 0;
  }
}
}  // namespace f1tenth_sim2d
