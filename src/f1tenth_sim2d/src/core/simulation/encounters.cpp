#include "core/simulation/encounters.h"

#include <algorithm>
#include <cmath>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kNear = 0.02;       // m, nearer than this a car takes part
constexpr double kLookAhead = 1.0;   // m, farther away need not be told apart
constexpr int kStepsNear = 10;       // after which a near car checks again
constexpr double kTravelMax = 10.0;  // m in a step; more means that the motion diverges

double checkedTravel(const RegisteredCar & car, double dt)
{
  const double travel = car.car.predictedTravel(car.body->participant.outer_radius);
  if (!(travel <= kTravelMax)) {
    throw Error(
      car.description.name + ": would go " + toText(travel) + " m in a step of " + toText(dt) +
      " s: no car has parameters like its own");
  }
  return travel;
}

void look(const Cars & cars, const CollisionWorld & world, std::size_t own, double approach)
{
  Surroundings & around = cars[own]->surroundings;
  if (around.steps_left > 0) {
    --around.steps_left;
    return;
  }
  around.free -= approach;
  around.is_near = around.free <= kNear;
  if (around.is_near) {
    around.free = clearance(placedCars(cars), own, world, kLookAhead) - approach;
    around.is_near = around.free <= kNear;
    around.steps_left = around.is_near ? kStepsNear : 0;
  }
}

// Returns the farthest that anything taking part moves in this step.
double lookAround(const Cars & cars, const CollisionWorld & world, double dt)
{
  const double movable_travel = world.movableTravel(dt);
  double car_travel = 0.0;
  for (const auto & car : cars) {
    car->surroundings.travel = checkedTravel(*car, dt);
    car_travel = std::max(car_travel, car->surroundings.travel);
  }
  const double others = std::max(movable_travel, cars.size() > 1 ? car_travel : 0.0);
  double near_travel = movable_travel;
  for (std::size_t i = 0; i < cars.size(); ++i) {
    const double own = cars[i]->surroundings.travel;
    look(cars, world, i, own + others);
    if (cars[i]->surroundings.is_near) {
      near_travel = std::max(near_travel, own);
    }
  }
  return near_travel;
}
}  // namespace

void forgetSurroundings(const Cars & cars) noexcept
{
  for (const auto & car : cars) {
    car->surroundings = {};
  }
}

bool applyContacts(const Cars & cars, CollisionWorld & world, double dt, bool spares_far_cars)
{
  const double travel = std::min(lookAround(cars, world, dt), kTravelMax);
  const bool any_near =
    std::any_of(cars.begin(), cars.end(), [](const auto & car) { return car->surroundings.is_near; });
  if (spares_far_cars && !any_near && !world.isAwake()) {
    return false;
  }
  for (const auto & car : cars) {
    if (car->surroundings.is_near || !spares_far_cars) {
      world.place(*car->body, car->car.predictedMotion());
    } else {
      CollisionWorld::remove(*car->body);
    }
  }
  world.step(dt, travel);
  // A model that was struck in this step moved, though it stood still before.
  const double struck = world.movableTravel(dt);
  for (const auto & car : cars) {
    car->surroundings.free -= struck;
    if (!car->body->contacts.empty()) {
      car->car.apply(CollisionWorld::effect(*car->body));
    }
  }
  return true;
}
}  // namespace f1tenth_sim2d
