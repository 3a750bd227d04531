#include "core/simulation/car_registry.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
std::string text(CarId id)
{
  return std::to_string(static_cast<std::uint32_t>(id));
}

[[noreturn]] void refuse(CarId unknown, const std::vector<CarId> & known)
{
  std::string message = "there is no car " + text(unknown);
  for (const CarId id : known) {
    message += (id == known.front() ? ", only " : ", ") + text(id);
  }
  throw std::out_of_range(message);
}
}  // namespace

CarRegistry::CarRegistry(const CarRegistry & other) : ids_(other.ids_), next_id_(other.next_id_)
{
  for (const auto & car : other.cars_) {
    cars_.push_back(std::make_unique<RegisteredCar>(*car));
  }
}

std::size_t CarRegistry::indexOf(CarId id) const
{
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (found == ids_.end() || *found != id) {
    refuse(id, ids_);
  }
  return static_cast<std::size_t>(found - ids_.begin());
}

std::uint32_t CarRegistry::freeNoiseStream() const
{
  const auto taken = [this](std::uint32_t stream) {
    return std::any_of(cars_.begin(), cars_.end(), [&](const auto & car) { return car->noise_stream == stream; });
  };
  std::uint32_t stream = 0;
  while (taken(stream)) {
    ++stream;
  }
  return stream;
}

void CarRegistry::reserve()
{
  cars_.reserve(cars_.size() + 1);
  ids_.reserve(ids_.size() + 1);
}

void CarRegistry::add(std::unique_ptr<RegisteredCar> car) noexcept
{
  ids_.push_back(car->id);
  cars_.push_back(std::move(car));
  ++next_id_;
}

void CarRegistry::remove(CarId id)
{
  const auto index = static_cast<std::ptrdiff_t>(indexOf(id));
  cars_.erase(cars_.begin() + index);
  ids_.erase(ids_.begin() + index);
}
}  // namespace f1tenth_sim2d
