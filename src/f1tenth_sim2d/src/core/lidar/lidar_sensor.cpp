#include "core/lidar/lidar_sensor.h"

#include "core/lidar/beam_kernels.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
LidarSensor::LidarSensor(const LidarDescription & description, const LidarScene & scene)
: description_(description),
  mount_(planar(description.pose)),
  scene_(&scene),
  spaces_(&scene.world().spacesFor(description))
{
}

void LidarSensor::scan(
  CarId own, const Pose2 & car, const MovingPoses & poses, std::optional<std::uint64_t> noise_key, float * ranges) const
{
  const ScanSpaces::Loan space = spaces_->borrow();
  space->raster.begin(chain(car, mount_), description_.range_max);
  scene_->draw(own, poses, space->raster, space->drawn);
  if (noise_key) {
    gaussians(*noise_key, space->normal.size(), space->normal.data());
  }
  const double mean = noise_key ? description_.noise_mean : 0.0;
  const double stddev = noise_key ? description_.noise_stddev : 0.0;
  reportRanges(
    space->raster.inverseRanges(), space->normal.data(), space->normal.size(), mean, stddev,
    {description_.range_min, description_.range_max}, ranges);
}
}  // namespace f1tenth_sim2d
