#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "f1tenth_sim2d/vehicle_parameters.h"

/// The numeric parameters, for readers and bindings.
namespace f1tenth_sim2d::vehicle_keys
{
/// Which numbers are allowed.
struct Range
{
  double least;
  double greatest;
  bool least_included;
  const char * text;

  bool contains(double value) const
  {
    return std::isfinite(value) && value <= greatest && (value > least || (least_included && value == least));
  }
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr Range kPositive{0.0, kInfinity, false, "numbers greater than 0"};
inline constexpr Range kNotNegative{0.0, kInfinity, true, "numbers from 0"};
inline constexpr Range kNotPositive{-kInfinity, 0.0, true, "numbers up to 0"};
inline constexpr Range kSteeringAngle{0.0, 1.5, false, "numbers greater than 0, up to 1.5 rad"};
inline constexpr Range kSteeringOffset{-1.5, 1.5, true, "numbers from -1.5 to 1.5 rad"};
inline constexpr Range kLatency{0.0, 1.0, true, "numbers from 0 to 1 s"};
inline constexpr Range kShare{0.0, 1.0, true, "numbers from 0 to 1"};
inline constexpr Range kNegative{-kInfinity, -1e-9, true, "numbers less than 0"};
inline constexpr Range kCurvature{-kInfinity, 1.0, true, "numbers up to 1"};
inline constexpr Range kFinite{-kInfinity, kInfinity, true, "numbers"};
inline constexpr Range kRate{0.0, 1000.0, false, "numbers greater than 0, up to 1000 Hz"};

/// A parameter: its key in YAML files and its name in Python.
template <typename Parameters>
struct Key
{
  const char * name;
  double Parameters::*member;
  Range range;
  const char * what = "";
};

using P = VehicleParameters;
inline constexpr std::array kVehicle{
  Key<P>{"m", &P::m, kPositive, "Mass, kg."},
  Key<P>{"l_f", &P::l_f, kPositive, "Centre of mass to front axle, m."},
  Key<P>{"l_r", &P::l_r, kPositive, "Centre of mass to rear axle, m."},
  Key<P>{"h", &P::h, kNotNegative, "Height of the centre of mass, m."},
  Key<P>{"I_z", &P::I_z, kPositive, "Yaw inertia, kg m^2."},
  Key<P>{"mu", &P::mu, kPositive, "Friction coefficient of tyre on ground."},
  Key<P>{"C_Sf", &P::C_Sf, kPositive, "Cornering stiffness coefficient of the front tyres, 1/rad."},
  Key<P>{"C_Sr", &P::C_Sr, kPositive, "Cornering stiffness coefficient of the rear tyres, 1/rad."},
  Key<P>{"steering_max", &P::steering_max, kSteeringAngle, "Greatest steering angle to either side, rad."},
  Key<P>{"steering_rate_max", &P::steering_rate_max, kPositive, "rad/s."},
  Key<P>{"a_max", &P::a_max, kPositive, "Greatest acceleration and braking, m/s^2."},
  Key<P>{"v_switch", &P::v_switch, kPositive, "Speed above which a_max falls with 1/v, m/s."},
  Key<P>{"v_min", &P::v_min, kNotPositive, "Fastest backwards, m/s."},
  Key<P>{"v_max", &P::v_max, kPositive, "Fastest forwards, m/s."},
  Key<P>{"actuation_latency", &P::actuation_latency, kLatency, "From command to actuator, s."},
  Key<P>{"speed_gain", &P::speed_gain, kPositive, "Acceleration asked for per speed error, 1/s."},
  Key<P>{"command_timeout", &P::command_timeout, kPositive, "Simulated time without a command before braking, s."},
  Key<P>{"R_w", &P::R_w, kPositive, "Radius of the wheels, m; this and the next three are the drift model's."},
  Key<P>{"I_y_w", &P::I_y_w, kPositive, "Inertia of the wheels of an axle about that axle, kg m^2."},
  Key<P>{"T_sb", &P::T_sb, kShare, "Share of the front axle in braking."},
  Key<P>{"T_se", &P::T_se, kShare, "Share of the front axle in driving."},
  Key<P>{"odometry_rate_hz", &P::odometry_rate_hz, kRate, "Hz."},
  Key<P>{"odometry_speed_scale", &P::odometry_speed_scale, kPositive, "Measured over true distance."},
  Key<P>{"odometry_speed_noise_stddev", &P::odometry_speed_noise_stddev, kNotNegative, "m/s per sample."},
  Key<P>{"odometry_steering_offset", &P::odometry_steering_offset, kSteeringOffset, "rad."},
  Key<P>{"odometry_steering_noise_stddev", &P::odometry_steering_noise_stddev, kNotNegative, "rad per sample."}};

using T = TireParameters;
inline constexpr std::array kTire{Key<T>{"p_cx1", &T::p_cx1, kPositive},  Key<T>{"p_dx1", &T::p_dx1, kPositive},
                                  Key<T>{"p_ex1", &T::p_ex1, kCurvature}, Key<T>{"p_kx1", &T::p_kx1, kPositive},
                                  Key<T>{"p_hx1", &T::p_hx1, kFinite},    Key<T>{"p_vx1", &T::p_vx1, kFinite},
                                  Key<T>{"r_bx1", &T::r_bx1, kFinite},    Key<T>{"r_bx2", &T::r_bx2, kFinite},
                                  Key<T>{"r_cx1", &T::r_cx1, kFinite},    Key<T>{"r_ex1", &T::r_ex1, kCurvature},
                                  Key<T>{"r_hx1", &T::r_hx1, kFinite},    Key<T>{"p_cy1", &T::p_cy1, kPositive},
                                  Key<T>{"p_dy1", &T::p_dy1, kPositive},  Key<T>{"p_ey1", &T::p_ey1, kCurvature},
                                  Key<T>{"p_ky1", &T::p_ky1, kNegative},  Key<T>{"r_by1", &T::r_by1, kFinite},
                                  Key<T>{"r_by2", &T::r_by2, kFinite},    Key<T>{"r_by3", &T::r_by3, kFinite},
                                  Key<T>{"r_cy1", &T::r_cy1, kFinite},    Key<T>{"r_ey1", &T::r_ey1, kCurvature},
                                  Key<T>{"r_hy1", &T::r_hy1, kFinite},    Key<T>{"r_vy1", &T::r_vy1, kFinite},
                                  Key<T>{"r_vy4", &T::r_vy4, kFinite},    Key<T>{"r_vy5", &T::r_vy5, kFinite},
                                  Key<T>{"r_vy6", &T::r_vy6, kFinite}};
}  // namespace f1tenth_sim2d::vehicle_keys
