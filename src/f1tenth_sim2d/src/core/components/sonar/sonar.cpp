#include "core/components/sonar/sonar.h"

#include <algorithm>
#include <utility>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
Sonar::Sonar(Mount mount, Options options) : CopiedComponent(std::move(mount)), options_(std::move(options)) {}

std::vector<Channel> Sonar::channels() const
{
  // Noise may make a range negative.
  return {{"range", 1, -options_.rays.range_max, options_.rays.range_max}};
}

void Sonar::sample(const Simulation & simulation, CarId car, double * numbers) const
{
  std::vector<double> ranges(options_.rays.directions.size());
  simulation.castRays(car, options_.rays, ranges.data());
  const double noise = options_.noise_stddev * simulation.noise(car, mount().name, 0);
  const double nearest = *std::min_element(ranges.begin(), ranges.end());
  numbers[0] = std::min(nearest + noise, options_.rays.range_max);
}
}  // namespace f1tenth_sim2d
