#pragma once

#include <array>
#include <string>

namespace f1tenth_sim2d
{
/// How a car that steers moves; docs/core.md describes the models.
enum class VehicleModel
{
  kSingleTrack,
  kKinematic,
  kSingleTrackDrift
};
/// Their names, in the order of the enum.
constexpr std::array<const char *, 3> kVehicleModelNames{"single_track", "kinematic", "single_track_drift"};

/// Coefficients of Pacejka's magic formula as in CommonRoad, "Vehicle Models", table 7, except r_hx1, r_by3 and r_vy1,
/// which make a tyre one-sided: those of the left and the right wheels cancel. There are none of camber, which is not
/// modelled. Forces are positive to the left, where the slip angle grows, so p_ky1 is negative.
struct TireParameters
{
  double p_cx1{1.6411};       ///< shape, along the wheel
  double p_dx1{1.1739};       ///< friction coefficient along the wheel
  double p_ex1{0.46403};      ///< curvature
  double p_kx1{22.303};       ///< stiffness over load
  double p_hx1{0.0012297};    ///< shift of the slip
  double p_vx1{-8.8098e-06};  ///< 1/N, shift of the force over load
  double r_bx1{13.276};       ///< stiffness of the weakening by the slip angle
  double r_bx2{-13.778};      ///< how it changes with slip
  double r_cx1{1.2568};       ///< its shape
  double r_ex1{0.65225};      ///< its curvature
  double r_hx1{0.0};          ///< rad, its shift
  double p_cy1{1.3507};       ///< shape, across the wheel
  double p_dy1{1.0489};       ///< friction coefficient across the wheel
  double p_ey1{-0.0074722};   ///< curvature
  double p_ky1{-21.92};       ///< 1/rad, stiffness over load
  double r_by1{7.1433};       ///< stiffness of the weakening by slip
  double r_by2{9.1916};       ///< how it changes with the slip angle
  double r_by3{0.0};          ///< rad, from where
  double r_cy1{1.0719};       ///< its shape
  double r_ey1{-0.27572};     ///< its curvature
  double r_hy1{5.7448e-06};   ///< its shift
  double r_vy1{0.0};          ///< force across the wheel by slip along it, over mu times load
  double r_vy4{12.12};        ///< how it falls with the slip angle
  double r_vy5{1.9};          ///< its shape
  double r_vy6{-10.704};      ///< its stiffness
};

/// All numbers of a car's dynamics, actuation and wheel odometry: one YAML file per car.
/// Symbols as in CommonRoad's vehicle models; defaults are the F1/10 car of f1tenth_gym.
struct VehicleParameters
{
  VehicleModel model{VehicleModel::kSingleTrack};

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

  // Of the drift model only.
  double R_w{0.05};      ///< m, radius of the wheels
  double I_y_w{0.0003};  ///< kg m^2, inertia of the two wheels of an axle about that axle
  double T_sb{0.5};      ///< share of the front axle in braking
  double T_se{0.5};      ///< share of the front axle in driving
  TireParameters tire;

  double odometry_rate_hz{50.0};
  double odometry_speed_scale{1.0};              ///< measured over true distance: a systematic drift
  double odometry_speed_noise_stddev{0.02};      ///< m/s, white, per sample
  double odometry_steering_offset{0.0};          ///< rad, systematic
  double odometry_steering_noise_stddev{0.005};  ///< rad, white, per sample

  double wheelbase() const { return l_f + l_r; }
};

/// The model of a name. @throws Error that lists the names
VehicleModel vehicleModel(const std::string & name);

/// Reads a car's YAML file. Every key is optional and defaults as above.
/// @throws LoadError naming file and line for an unknown key, a wrong type or a value out of range
VehicleParameters loadVehicleParameters(const std::string & path);
}  // namespace f1tenth_sim2d
