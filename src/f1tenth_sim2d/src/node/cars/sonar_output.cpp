#include "node/cars/sonar_output.h"

#include <algorithm>

namespace f1tenth_sim2d
{
SonarOutput::SonarOutput(const CarHandle & car, const SonarDescription & sonar)
: SensorOutput(car, sonar), ranges_(sonar.rays.directions.size())
{
  message_.radiation_type = sonar.is_infrared ? sensor_msgs::Range::INFRARED : sensor_msgs::Range::ULTRASOUND;
  message_.field_of_view = static_cast<float>(sonar.field_of_view);
  message_.min_range = static_cast<float>(sonar.range_min);
  message_.max_range = static_cast<float>(sonar.rays.range_max);
}

void SonarOutput::sample(sensor_msgs::Range & message)
{
  car_.simulation.castRays(car_.id, sensor_.rays, ranges_.data());
  const double noise = sensor_.noise_stddev * car_.simulation.noise(car_.id, sensor_.name, 0);
  const double nearest = *std::min_element(ranges_.begin(), ranges_.end());
  message.range = static_cast<float>(std::min(nearest + noise, sensor_.rays.range_max));
}
}  // namespace f1tenth_sim2d
