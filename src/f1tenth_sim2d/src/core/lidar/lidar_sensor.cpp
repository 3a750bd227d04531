#include "core/lidar/lidar_sensor.h"

#include <algorithm>
#include <utility>

#include "core/lidar/beam_kernels.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
/// An upright lidar with the beams of this one in the opposite order.
LidarDescription turnedOver(LidarDescription lidar)
{
  std::swap(lidar.angle_min, lidar.angle_max);
  lidar.angle_min = -lidar.angle_min;
  lidar.angle_max = -lidar.angle_max;
  return lidar;
}
}  // namespace

LidarSensor::LidarSensor(const LidarDescription & description, const LidarScene & scene)
: description_(description),
  is_upside_down_(description.pose.up().z() < 0.0),
  mount_(planar(description.pose)),
  scene_(&scene),
  spaces_(&scene.world().spacesFor(is_upside_down_ ? turnedOver(description) : description))
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
  if (is_upside_down_) {
    std::reverse(ranges, ranges + description_.beam_count);
  }
}
}  // namespace f1tenth_sim2d
