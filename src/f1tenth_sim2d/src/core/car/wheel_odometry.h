#pragma once

#include <cstdint>

#include "core/models/body_state.h"
#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// Dead reckoning as a car does it: distance from the wheels, curvature from the steering angle, both with noise and
/// systematic errors; a car that is driven by velocities takes its curvature from the difference of its wheels. Sampled
/// at a fixed rate whether anybody reads it or not.
class WheelOdometryIntegrator
{
public:
  /// @param steers        whether the car turns by steering
  /// @param track_width   m, between the wheels
  /// @param noise_stream  of the car
  WheelOdometryIntegrator(
    const VehicleParameters & parameters, bool steers, double track_width, std::uint64_t seed,
    std::uint32_t noise_stream);

  /// @param now  the first sample falls on the first multiple of the sampling period after it
  void restart(const Pose2 & pose, SimTime now);

  /// Notes what happened in a step of dt seconds that ends at now.
  /// @param state     at its end
  /// @param distance  m, that the wheels of the rear axle rolled
  /// @param turn      rad, of the car
  void advance(const BodyState & state, double distance, double turn, double dt, SimTime now);

  const WheelOdometry & current() const { return current_; }

private:
  void sampleSteered(double steering_angle);
  void sampleFree();
  std::uint64_t noiseKeyNow() const;
  double measuredSpeed(double distance, double noise) const;
  void integrate();
  void beginSample(std::int64_t number);

  VehicleParameters parameters_;
  bool steers_;
  double track_width_;  ///< m
  std::uint64_t seed_;
  std::uint32_t noise_stream_;
  WheelOdometry current_;
  std::int64_t next_sample_{1};
  SimTime next_time_{0};
  // Since the last sample.
  double distance_{0.0};  ///< m
  double sideways_{0.0};  ///< m
  double turn_{0.0};      ///< rad
  double elapsed_{0.0};   ///< s
  double last_steering_angle_{0.0};
};
}  // namespace f1tenth_sim2d
