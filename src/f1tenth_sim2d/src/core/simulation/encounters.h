#pragma once

#include <vector>

#include "core/contacts/collision_world.h"
#include "core/simulation/car_registry.h"

namespace f1tenth_sim2d
{
/// Decides which cars are near anything that they could touch, and lets only those take part in the rigid-body world.
///
/// Each car keeps a distance that it may go before it has to look again: what was free around it when it last looked,
/// less what it and everything else that moves may have gone since. Far from everything a step costs a subtraction.
class Encounters
{
public:
  void addCar() { cars_.emplace_back(); }
  void restart();

  /// Applies contacts to the predicted motion of all cars in a step of dt seconds.
  /// @return whether the rigid-body world was advanced
  bool advance(const Cars & cars, CollisionWorld & world, double dt);

  /// Whether a car took part in the last step.
  bool tookPart(std::size_t car) const { return cars_[car].is_near; }

private:
  struct Surroundings
  {
    double free{0.0};   ///< m, that nothing can have come nearer than
    int steps_left{0};  ///< for which the car counts as near without looking
    bool is_near{false};
  };

  void look(const Cars & cars, const CollisionWorld & world, std::size_t car, double approach);
  double update(const Cars & cars, const CollisionWorld & world, double dt);

  std::vector<Surroundings> cars_;
};

/// The places of all cars.
std::vector<PlacedCar> placedCars(const Cars & cars);
}  // namespace f1tenth_sim2d
