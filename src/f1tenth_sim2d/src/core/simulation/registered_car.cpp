#include "core/simulation/registered_car.h"

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
