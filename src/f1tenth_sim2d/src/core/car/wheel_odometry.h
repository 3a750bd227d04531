#pragma once

#include <cstdint>

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/sensor_samples.h"
#include "f1tenth_sim2d/sim_time.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// Dead reckoning as a car does it: distance from the wheels, curvature from the steering angle, both with noise and
/// systematic errors; a car that is driven by velocities has its curvature from the difference of its wheels. Sampled at a
/// fixed rate whether anybody reads it or not.
class WheelOdometryIntegrator
{
public:
  /// @param noise_stream  of the car
  WheelOdometryIntegrator(const VehicleParameters & parameters, std::uint64_t seed, std::uint32_t noise_stream);

  /// @param now  the first sample falls on the first multiple of the sampling period after it
  void restart(const Pose2 & pose, double steering_angle, SimTime now);

  /// Tells what happened in a step of dt seconds that ends at now.
  /// @param distance  m, that the middle of the rear axle rolled
  void advance(double distance, double steering_angle, double dt, SimTime now);
  /// The same of a car that is driven by velocities.
  /// @param way          m, that the middle of the rear axle went, in the frame of the car
  /// @param turn         rad
  /// @param track_width  m, between the wheels
  void advanceFreely(const Vec2 & way, double turn, double track_width, double dt, SimTime now);

  const WheelOdometry & current() const { return current_; }

private:
  bool isDue(SimTime now) const;
  void sampleSteered(double steering_angle);
  void sampleFree(double track_width);
  std::uint64_t noiseKeyNow() const;
  double measuredSpeed(double distance, double noise) const;
  void integrate();
  SimTime sampleTime(std::int64_t number) const;

  VehicleParameters parameters_;
  std::uint64_t seed_;
  std::uint32_t noise_stream_;
  WheelOdometry current_;
  std::int64_t next_sample_{1};
  SimTime next_time_{0};
  double distance_{0.0};
  double sideways_{0.0};
  double turn_{0.0};
  double elapsed_{0.0};
  double last_steering_angle_{0.0};
};
}  // namespace f1tenth_sim2d
