#include "core/lidar/lidar_sensor.h"

#include "core/lidar/beam_kernels.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
RangeLimits limitsOf(const LidarDescription & lidar)
{
  return {lidar.range_min, lidar.range_max};
}
}  // namespace

LidarSensor::Space::Space(const LidarDescription & lidar, const LidarScene & scene)
: raster(lidar), drawn(scene.world().walls().itemCount()), normal(static_cast<std::size_t>(raster.beamCount()))
{
}

LidarSensor::LidarSensor(const LidarDescription & description, const LidarScene & scene)
: description_(description),
  mount_(planar(description.pose)),
  scene_(&scene),
  space_(std::make_unique<Space>(description, scene))
{
}

void LidarSensor::measure(Space & space, CarId own, const Pose2 & car, const MovingPoses & poses) const
{
  space.raster.begin(chain(car, mount_));
  scene_->draw(own, poses, space.raster, space.drawn);
}

void LidarSensor::scan(CarId own, const Pose2 & car, const MovingPoses & poses, float * ranges) const
{
  Space & space = *space_;
  const std::lock_guard<std::mutex> lock(space.mutex);
  measure(space, own, car, poses);
  reportRanges(space.raster.inverseRanges(), space.normal.size(), limitsOf(description_), ranges);
}

void LidarSensor::noisyScan(
  CarId own, const Pose2 & car, const MovingPoses & poses, std::uint64_t key, float * ranges) const
{
  Space & space = *space_;
  const std::lock_guard<std::mutex> lock(space.mutex);
  measure(space, own, car, poses);
  gaussians(key, space.normal.size(), space.normal.data());
  reportNoisyRanges(
    space.raster.inverseRanges(), space.normal.data(), space.normal.size(), description_.noise_mean,
    description_.noise_stddev, limitsOf(description_), ranges);
}
}  // namespace f1tenth_sim2d
