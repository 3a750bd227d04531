#pragma once

#include <string>

namespace f1tenth_sim2d
{
/// All numbers of a car's dynamics, actuation and wheel odometry: one YAML file a car.
/// Symbols as in CommonRoad's vehicle models; defaults are the F1/10 car of f1tenth_gym.
struct VehicleParameters
{
  double m{3.74};                  ///< kg, mass
  double l_f{0.15875};             ///< m, centre of mass to front axle
  double l_r{0.17145};             ///< m, centre of mass to rear axle
  double h{0.074};                 ///< m, height of the centre of mass
  double I_z{0.04712};             ///< kg m^2, yaw inertia
  double mu{1.0489};               ///< friction coefficient of tyre on ground
  double C_Sf{4.718};              ///< 1/rad, cornering stiffness coefficient, front
  double C_Sr{5.4562};             ///< 1/rad, cornering stiffness coefficient, rear
  double steering_max{0.4189};     ///< rad, to either side
  double steering_rate_max{3.2};   ///< rad/s
  double a_max{9.51};              ///< m/s^2, acceleration and braking
  double v_switch{7.319};          ///< m/s, above it a_max falls with 1/v
  double v_min{-5.0};              ///< m/s
  double v_max{20.0};              ///< m/s
  double actuation_latency{0.02};  ///< s, command to actuator, fixed
  double speed_gain{10.0};         ///< 1/s, acceleration asked for per m/s of speed error
  double command_timeout{0.5};     ///< s of simulated time, then the car brakes to a stop

  double odometry_rate_hz{50.0};
  double odometry_speed_scale{1.0};              ///< measured over true distance: a systematic drift
  double odometry_speed_noise_stddev{0.02};      ///< m/s, white, per sample
  double odometry_steering_offset{0.0};          ///< rad, systematic
  double odometry_steering_noise_stddev{0.005};  ///< rad, white, per sample

  double wheelbase() const { return l_f + l_r; }
};

/// Reads a car's YAML file. Every key is optional and defaults as above.
/// @throws LoadError naming file and line for an unknown key, a wrong type or a value out of range
VehicleParameters loadVehicleParameters(const std::string & path);
}  // namespace f1tenth_sim2d
