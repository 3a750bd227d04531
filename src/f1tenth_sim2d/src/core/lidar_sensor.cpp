#include "lidar_sensor.h"

#include <limits>

#include "noise.h"
#include "planar_pose.h"

namespace f1tenth_sim2d
{
LidarSensor::LidarSensor(const LidarDescription & description, std::size_t scene)
: description_(description),
  mount_(planar(description.pose)),
  scene_(scene),
  raster_(description),
  exact_ranges_(raster_.beamCount())
{
}

void LidarSensor::measure(LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses)
{
  raster_.begin(compose(car, mount_));
  scene.draw(own_car, poses, raster_);
  raster_.finish(exact_ranges_.data());
}

// What lies outside the limits is said as REP-117 wants it.
float LidarSensor::report(double range) const
{
  if (range < description_.range_min) {
    return -std::numeric_limits<float>::infinity();
  }
  return range <= description_.range_max ? static_cast<float>(range) : std::numeric_limits<float>::infinity();
}

void LidarSensor::scan(
  LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses, float * ranges)
{
  measure(scene, own_car, car, poses);
  for (std::size_t i = 0; i < exact_ranges_.size(); ++i) {
    ranges[i] = report(exact_ranges_[i]);
  }
}

void LidarSensor::noisyScan(
  LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses, std::uint64_t key,
  float * ranges)
{
  measure(scene, own_car, car, poses);
  const double mean = description_.noise_mean;
  const double stddev = description_.noise_stddev;
  for (std::size_t i = 0; i < exact_ranges_.size(); ++i) {
    ranges[i] = report(exact_ranges_[i] + mean + stddev * gaussian(key, i));
  }
}
}  // namespace f1tenth_sim2d
