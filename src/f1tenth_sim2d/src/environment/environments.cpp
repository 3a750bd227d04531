#include "environment/environments.h"

#include <algorithm>
#include <string>
#include <utility>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
std::size_t atLeastOne(const char * what, std::size_t number)
{
  if (number == 0) {
    throw Error(std::string(what) + ": found 0, allowed are 1 or more");
  }
  return number;
}

Observation observationOf(const EnvironmentOptions & options)
{
  if (options.cars.empty()) {
    throw Error("cars: found 0, allowed are 1 or more");
  }
  if (options.cars.front().lidars.empty()) {
    throw Error(options.cars.front().name + ": the car has no lidar, allowed are 1 or more");
  }
  return {options.parts, options.cars, options.course ? options.course->length() : 0.0};
}
}  // namespace

Environments::Environments(
  const PreparedWorld & world, EnvironmentOptions options, std::size_t count, std::size_t threads)
: options_(std::move(options)),
  observation_(observationOf(options_)),
  pool_(std::min(atLeastOne("threads", threads), atLeastOne("environments", count)))
{
  for (std::size_t i = 0; i < count; ++i) {
    environments_.emplace_back(world, options_, observation_);
  }
  observations_.resize(count * cars() * observation().size());
  results_.resize(count * cars());
  times_.resize(count);
}

void Environments::reset(std::size_t index, std::uint64_t seed, const std::vector<CarStart> & starts)
{
  environments_.at(index).reset(seed, starts);
  publish(index);
}

void Environments::restore(std::size_t index, const Episode & episode)
{
  environments_.at(index).restore(episode);
  publish(index);
}

void Environments::step(const Action * actions, const std::uint8_t * driven)
{
  pool_.run(count(), [&](std::size_t index) {
    const std::uint8_t * const own = driven + index * cars();
    if (std::any_of(own, own + cars(), [](std::uint8_t each) { return each != 0; })) {
      environments_[index].step(actions + index * cars(), own);
      publish(index);
    }
  });
}

void Environments::publish(std::size_t index)
{
  const Environment & environment = environments_[index];
  environment.observe(observations_.data() + index * cars() * observation().size());
  std::copy(
    environment.cars().begin(), environment.cars().end(),
    results_.begin() + static_cast<std::ptrdiff_t>(index * cars()));
  times_[index] = environment.time();
}
}  // namespace f1tenth_sim2d
