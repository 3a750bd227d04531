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

LidarSensor::LidarSensor(const LidarDescription & description, const LidarScene & scene)
: description_(description),
  mount_(planar(description.pose)),
  scene_(&scene),
  spaces_(&scene.world().spacesFor(description))
{
}

void LidarSensor::measure(ScanSpace & space, CarId own, const Pose2 & car, const MovingPoses & poses) const
{
  space.raster.begin(chain(car, mount_), description_.range_max);
  scene_->draw(own, poses, space.raster, space.drawn);
}

void LidarSensor::scan(CarId own, const Pose2 & car, const MovingPoses & poses, float * ranges) const
{
  const ScanSpaces::Loan space = spaces_->borrow();
  measure(*space, own, car, poses);
  reportRanges(space->raster.inverseRanges(), space->normal.size(), limitsOf(description_), ranges);
}

void LidarSensor::noisyScan(
  CarId own, const Pose2 & car, const MovingPoses & poses, std::uint64_t key, float * ranges) const
{
  const ScanSpaces::Loan space = spaces_->borrow();
  measure(*space, own, car, poses);
  gaussians(key, space->normal.size(), space->normal.data());
  reportNoisyRanges(
    space->raster.inverseRanges(), space->normal.data(), space->normal.size(), description_.noise_mean,
    description_.noise_stddev, limitsOf(description_), ranges);
}
}  // namespace f1tenth_sim2d
