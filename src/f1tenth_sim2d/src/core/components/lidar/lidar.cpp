#include "core/components/lidar/lidar.h"

#include <algorithm>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
Lidar::Lidar(const LidarDescription & lidar, std::size_t index)
: CopiedComponent(Mount{lidar.name, lidar.topic, lidar.frame, lidar.pose, lidar.rate_hz}),
  description_(lidar),
  index_(index)
{
}

std::vector<Channel> Lidar::channels() const
{
  return {{"ranges", static_cast<std::size_t>(description_.beam_count), 0.0, description_.range_max}};
}

void Lidar::sample(const Simulation & simulation, CarId car, double * numbers) const
{
  std::vector<float> ranges(static_cast<std::size_t>(description_.beam_count));
  simulation.scan(car, index_, ranges.data());
  std::copy(ranges.begin(), ranges.end(), numbers);
}
}  // namespace f1tenth_sim2d
