#include "core/lidar/lidar_sensor.h"

#include "core/lidar/beam_kernels.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
LidarSensor::LidarSensor(const LidarDescription & description, std::size_t scene)
: description_(description),
  mount_(planar(description.pose)),
  scene_(scene),
  raster_(description),
  limits_{description.range_min, description.range_max},
  normal_(raster_.beamCount())
{
}

void LidarSensor::measure(LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses)
{
  raster_.begin(compose(car, mount_));
  scene.draw(own_car, poses, raster_);
}

void LidarSensor::scan(
  LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses, float * ranges)
{
  measure(scene, own_car, car, poses);
  reportRanges(raster_.inverseRanges(), normal_.size(), limits_, ranges);
}

void LidarSensor::noisyScan(
  LidarScene & scene, std::size_t own_car, const Pose2 & car, const MovingPoses & poses, std::uint64_t key,
  float * ranges)
{
  measure(scene, own_car, car, poses);
  gaussians(key, normal_.size(), normal_.data());
  reportNoisyRanges(
    raster_.inverseRanges(), normal_.data(), normal_.size(), description_.noise_mean, description_.noise_stddev,
    limits_, ranges);
}
}  // namespace f1tenth_sim2d
