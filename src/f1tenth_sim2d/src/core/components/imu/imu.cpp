#include "core/components/imu/imu.h"

#include <algorithm>
#include <utility>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kGyroscopeMax = 1000.0;       // rad/s, beyond all that a car does
constexpr double kAccelerometerMax = 10000.0;  // m/s^2, likewise, collisions included
}  // namespace

Imu::Imu(Mount mount, Noise noise) : CopiedComponent(std::move(mount)), noise_(noise) {}

std::vector<Channel> Imu::channels() const
{
  return {
    {"orientation", 4, -1.0, 1.0},
    {"angular_velocity", 3, -kGyroscopeMax, kGyroscopeMax},
    {"linear_acceleration", 3, -kAccelerometerMax, kAccelerometerMax}};
}

void Imu::sample(const Simulation & simulation, CarId car, double * numbers) const
{
  const CarState state = simulation.state(car);
  const auto noise = [&](std::uint64_t index) { return simulation.noise(car, mount().name, index); };
  const Pose3::Rotation in_world = Pose3::rotationOf(0.0, 0.0, state.pose.yaw) * mount().pose.rotation;
  const Pose3::Rotation to_sensor = mount().pose.rotation.conjugate();
  const Eigen::Vector3d turning(0.0, 0.0, state.yaw_rate + noise_.yaw_rate_stddev * noise(0));
  const Eigen::Vector3d pushed(
    state.acceleration.x + noise_.acceleration_stddev * noise(1),
    state.acceleration.y + noise_.acceleration_stddev * noise(2), simulation.world().gravity);
  std::copy_n(in_world.coeffs().data(), 4, numbers + kOrientation);
  std::copy_n((to_sensor * turning).eval().data(), 3, numbers + kAngularVelocity);
  std::copy_n((to_sensor * pushed).eval().data(), 3, numbers + kAcceleration);
}
}  // namespace f1tenth_sim2d
