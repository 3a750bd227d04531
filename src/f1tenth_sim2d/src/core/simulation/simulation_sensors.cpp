#include <algorithm>
#include <limits>

#include "core/lidar/beam_kernels.h"
#include "core/math/noise.h"
#include "core/math/planar_pose.h"
#include "core/simulation/simulation_impl.h"
#include "core/simulation/validation.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kFarthest = 1e6;  // m; no world is that large, and an infinite ray would never end
}  // namespace

WheelOdometry Simulation::wheelOdometry(CarId car) const
{
  return impl_->car(car).car.wheelOdometry();
}

void Simulation::scan(CarId car, std::size_t lidar, float * ranges) const
{
  impl_->scan(car, lidar, true, ranges);
}

void Simulation::exactScan(CarId car, std::size_t lidar, float * ranges) const
{
  impl_->scan(car, lidar, false, ranges);
}

void Simulation::Impl::scan(CarId id, std::size_t index, bool noisy, float * ranges) const
{
  const RegisteredCar & own = car(id);
  const LidarDescription & lidar = own.description.lidars.at(index);
  const LidarScene & scene = sceneAt(lidar.pose.position.z());
  const ScanSpaces::Loan space = scene.spaceFor(beamsOf(lidar));
  scene.draw(id, chain(own.car.pose(), planar(lidar.pose)), lidar.range_max, *this, *space);
  const double mean = noisy ? lidar.noise_mean : 0.0;
  const double stddev = noisy ? lidar.noise_stddev : 0.0;
  if (stddev != 0.0) {
    const auto now = static_cast<std::uint64_t>(time);
    const std::uint64_t key = noiseKey(options.seed, own.noise_stream, NoiseStream::kLidar, index, now);
    gaussians(key, space->normal.size(), space->normal.data());
  }
  reportRanges(
    space->raster.inverseRanges(), space->normal.data(), space->normal.size(), mean, stddev,
    {lidar.range_min, lidar.range_max}, ranges);
  if (isUpsideDown(lidar)) {
    std::reverse(ranges, ranges + lidar.beam_count);
  }
}

void Simulation::castRays(CarId id, const RayFan & fan, double * ranges) const
{
  const RegisteredCar & own = impl_->car(id);
  validate(fan, own.description.name);
  const Pose2 origin = chain(own.car.pose(), fan.origin);
  const LidarScene & scene = impl_->sceneAt(fan.height);
  const double range_max = std::min(kFarthest, fan.range_max);
  const ScanSpaces::Loan space = scene.spaceFor(Beams{});
  for (std::size_t i = 0; i < fan.directions.size(); ++i) {
    scene.draw(id, {origin.x, origin.y, origin.yaw + fan.directions[i]}, range_max, *impl_, *space);
    const double range = 1.0 / space->raster.inverseRanges()[0];
    ranges[i] = range < fan.range_max ? range : std::numeric_limits<double>::infinity();
  }
}

std::uint64_t Simulation::Impl::keyOfNoise(CarId id, const std::string & sensor) const
{
  const auto now = static_cast<std::uint64_t>(time);
  return noiseKey(options.seed, car(id).noise_stream, NoiseStream::kNamedSensor, hashOf(sensor), now);
}

double Simulation::noise(CarId id, const std::string & sensor, std::uint64_t index) const
{
  return gaussian(impl_->keyOfNoise(id, sensor), index);
}

void Simulation::noises(CarId id, const std::string & sensor, std::size_t count, double * samples) const
{
  gaussians(impl_->keyOfNoise(id, sensor), count, samples);
}
}  // namespace f1tenth_sim2d
