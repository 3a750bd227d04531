#pragma once

#include "f1tenth_sim2d/component.h"

namespace f1tenth_sim2d
{
/// An inertial measurement unit. It measures along its own axes: its orientation in the world (a quaternion x, y, z, w),
/// angular velocity (rad/s) and acceleration including gravity (m/s^2).
class Imu : public CopiedComponent<Imu>
{
public:
  /// Of each axis in which a car in the plane moves.
  struct Noise
  {
    double yaw_rate_stddev{0.0};      ///< rad/s
    double acceleration_stddev{0.0};  ///< m/s^2
  };
  /// A sample, channel by channel.
  enum Numbers : std::size_t
  {
    kOrientation = 0,
    kAngularVelocity = 4,
    kAcceleration = 7,
    kSize = 10
  };

  Imu(Mount mount, Noise noise);

  const Noise & noise() const { return noise_; }
  std::vector<Channel> channels() const override;
  void sample(const Simulation & simulation, CarId car, double * numbers) const override;

private:
  Noise noise_;
};
}  // namespace f1tenth_sim2d
