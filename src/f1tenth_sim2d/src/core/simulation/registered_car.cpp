#include "core/simulation/registered_car.h"

#include <utility>

#include "core/components/lidar/lidar.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
RegisteredCar::RegisteredCar(
  CarId car_id, std::uint32_t stream, const CarDescription & car_description, const VehicleParameters & parameters,
  const Pose2 & start, std::uint64_t seed, const WorldPieces & world)
: id(car_id),
  noise_stream(stream),
  description(car_description),
  car(description, parameters, start, seed, stream),
  body(makeBody(world))
{
  for (std::size_t i = 0; i < description.lidars.size(); ++i) {
    mount(std::make_shared<Lidar>(description.lidars[i], i));
  }
  for (const auto & prototype : description.components) {
    mount(prototype->clone());
  }
}

RegisteredCar::RegisteredCar(const RegisteredCar & other)
: id(other.id),
  noise_stream(other.noise_stream),
  description(other.description),
  car(other.car),
  body(std::make_unique<CarBody>(*other.body)),
  contacts(other.contacts)
{
  for (const auto & component : other.components) {
    std::shared_ptr<Component> copy = component->clone();
    if (!copy) {
      throw Error(description.name + ": the component " + component->mount().name + " cannot be copied");
    }
    mount(std::move(copy));
  }
}

void RegisteredCar::mount(std::shared_ptr<Component> component)
{
  acting.reserve(acting.size() + 1);
  components.push_back(std::move(component));
  if (components.back()->acts()) {
    acting.push_back(components.back().get());
  }
}

std::unique_ptr<CarBody> RegisteredCar::makeBody(const WorldPieces & world) const
{
  const VehicleParameters & p = car.parameters();
  return std::make_unique<CarBody>(id, description.solids, p.l_r, p.m, p.I_z, world);
}

std::vector<PlacedCar> placedCars(const Cars & cars)
{
  std::vector<PlacedCar> placed;
  placed.reserve(cars.size());
  for (const auto & car : cars) {
    placed.push_back(car->placed());
  }
  return placed;
}
}  // namespace f1tenth_sim2d
