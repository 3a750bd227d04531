#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/simulation/registered_car.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// Owns the cars of a simulation, in the order in which they were added.
class CarRegistry
{
public:
  CarRegistry() = default;
  /// With copies of the cars.
  CarRegistry(const CarRegistry & other);

  const Cars & cars() const { return cars_; }
  const std::vector<CarId> & ids() const { return ids_; }

  /// Where a car stands in cars() now. @throws std::out_of_range for one that is not there
  std::size_t indexOf(CarId id) const;
  RegisteredCar & at(CarId id) const { return *cars_[indexOf(id)]; }

  /// For the car that comes next: an id that no car ever had, and the lowest noise stream that no car has now.
  CarId nextId() const { return CarId{next_id_}; }
  std::uint32_t freeNoiseStream() const;

  /// Makes room for one more car, so that adding it cannot fail.
  void reserve();
  /// Adds a car that was made with nextId().
  void add(std::unique_ptr<RegisteredCar> car) noexcept;
  void remove(CarId id);

private:
  Cars cars_;
  std::vector<CarId> ids_;
  std::uint32_t next_id_{0};
};
}  // namespace f1tenth_sim2d
