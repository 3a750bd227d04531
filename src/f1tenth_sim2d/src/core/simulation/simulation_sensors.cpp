#include <algorithm>
#include <limits>
#include <optional>

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

ImuSample Simulation::imu(CarId id) const
{
  const RegisteredCar & own = impl_->car(id);
  const CarState state = own.car.state();
  ImuSample sample{state.pose.yaw, state.yaw_rate, state.acceleration};
  if (const auto & imu = own.description.imu) {
    const std::uint64_t key =
      noiseKey(impl_->options.seed, own.noise_stream, NoiseStream::kImu, 0, static_cast<std::uint64_t>(impl_->time));
    sample.yaw_rate += imu->yaw_rate_noise_stddev * gaussian(key, 0);
    sample.acceleration.x += imu->acceleration_noise_stddev * gaussian(key, 1);
    sample.acceleration.y += imu->acceleration_noise_stddev * gaussian(key, 2);
  }
  return sample;
}

void Simulation::scan(CarId car, std::size_t lidar, float * ranges) const
{
  impl_->scan(car, lidar, true, ranges);
}

void Simulation::exactScan(CarId car, std::size_t lidar, float * ranges) const
{
  impl_->scan(car, lidar, false, ranges);
}

void Simulation::Impl::scan(CarId id, std::size_t lidar, bool noisy, float * ranges) const
{
  const RegisteredCar & own = car(id);
  std::optional<std::uint64_t> noise_key;
  if (noisy) {
    noise_key = noiseKey(options.seed, own.noise_stream, NoiseStream::kLidar, lidar, static_cast<std::uint64_t>(time));
  }
  own.lidars.at(lidar).scan(id, own.car.pose(), *this, noise_key, ranges);
}

void Simulation::castRays(CarId id, const RayFan & fan, double * ranges) const
{
  const RegisteredCar & own = impl_->car(id);
  validate(fan, own.description.name);
  const Pose2 origin = chain(own.car.pose(), fan.origin);
  const LidarScene & scene = [&]() -> const LidarScene & {
    const std::lock_guard<std::mutex> lock(impl_->scenes_mutex);
    return impl_->sceneAt(fan.height, impl_->cars(), *impl_->geometry, impl_->scenes);
  }();
  LidarDescription ray;
  ray.beam_count = 1;
  const double range_max = std::min(kFarthest, fan.range_max);
  const ScanSpaces::Loan space = scene.world().spacesFor(ray).borrow();
  for (std::size_t i = 0; i < fan.directions.size(); ++i) {
    space->raster.begin({origin.x, origin.y, origin.yaw + fan.directions[i]}, range_max);
    scene.draw(id, *impl_, space->raster, space->drawn);
    const double range = 1.0 / space->raster.inverseRanges()[0];
    ranges[i] = range < fan.range_max ? range : std::numeric_limits<double>::infinity();
  }
}

double Simulation::noise(CarId id, const std::string & sensor, std::uint64_t index) const
{
  const auto now = static_cast<std::uint64_t>(impl_->time);
  return gaussian(
    noiseKey(impl_->options.seed, impl_->car(id).noise_stream, NoiseStream::kNamedSensor, hashOf(sensor), now), index);
}
}  // namespace f1tenth_sim2d
