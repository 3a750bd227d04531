#pragma once

#include <boost/array.hpp>

#include <string>

#include "node/cars/controllers/controller_setup.h"
#include "node/cars/controllers/speed_limits.h"

namespace f1tenth_sim2d
{
/// Parameters of a steering controller, with the names and defaults of ros_controllers.
struct SteeringParameters
{
  using Covariance = boost::array<double, 36>;

  std::string rear_wheel{"rear_wheel_joint"};
  std::string front_steer{"front_steer_joint"};
  double wheel_separation_h{0.0};  ///< m, between the axles; of the car unless it is given
  double wheel_radius{0.0};        ///< m, likewise
  double wheel_separation_h_multiplier{1.0};
  double wheel_radius_multiplier{1.0};
  double steer_pos_multiplier{1.0};
  double cmd_vel_timeout{0.5};  ///< s
  SpeedLimits linear;
  SpeedLimits angular;  ///< of the steering angle

  double publish_rate{50.0};  ///< Hz
  std::string odom_frame_id{"odom"};
  std::string base_frame_id{"base_link"};
  bool enable_odom_tf{true};
  bool open_loop{false};  ///< odometry from what was commanded
  int velocity_rolling_window_size{10};
  Covariance pose_covariance{};
  Covariance twist_covariance{};
};

/// @throws workspace_support::OptionError
SteeringParameters readSteeringParameters(const ControllerSetup & setup);
}  // namespace f1tenth_sim2d
