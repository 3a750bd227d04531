#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/car/car.h"
#include "core/contacts/car_body.h"
#include "core/contacts/clearance.h"
#include "core/contacts/contact_log.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/component.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// How far a car may go before it has to look again whether it could touch something.
struct Surroundings
{
  double free{0.0};    ///< m, within which there can be nothing
  double travel{0.0};  ///< m, the farthest that a point of the car moves in this step
  int steps_left{0};   ///< for which the car counts as near without looking
  bool is_near{false};
};

/// A car of a simulation and all that belongs to it.
struct RegisteredCar
{
  /// @param stream  keeps its noise apart from that of the other cars
  /// @param start   pose of base_footprint
  RegisteredCar(
    CarId car_id, std::uint32_t stream, const CarDescription & car_description, const VehicleParameters & parameters,
    const Pose2 & start, std::uint64_t seed, const WorldPieces & world);
  /// With a body that no world has, and copies of all components.
  /// @throws Error for a component that cannot be copied
  RegisteredCar(const RegisteredCar & other);

  void mount(std::shared_ptr<Component> component);
  std::unique_ptr<CarBody> makeBody(const WorldPieces & world) const;
  PlacedCar placed() const { return {*body, car.centreOfMass()}; }

  const CarId id;
  const std::uint32_t noise_stream;
  const CarDescription description;
  Car car;
  std::unique_ptr<CarBody> body;
  Surroundings surroundings;
  ContactLog contacts;
  std::vector<std::shared_ptr<Component>> components;
  std::vector<Component *> acting;  ///< those that want to be called
};

using Cars = std::vector<std::unique_ptr<RegisteredCar>>;

/// The places of all cars.
std::vector<PlacedCar> placedCars(const Cars & cars);
}  // namespace f1tenth_sim2d
