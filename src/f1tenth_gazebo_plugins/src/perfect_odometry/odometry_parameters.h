#pragma once

#include <ros/console.h>

#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/car_model.h"

namespace f1tenth_gazebo_plugins
{
/// The tags of the plugin's element.
struct OdometryParameters
{
  bool always_on{true};          ///< false: publishes, transform included, only while somebody subscribes
  double update_rate_hz{200.0};  ///< of simulated time
  std::string topic{"perfect_odom"};
  std::string pose_topic;  ///< of the pose alone; empty: none
  std::string odometry_frame{"odom"};
  std::optional<ros::console::levels::Level> log_level;  ///< none: leaves the logger as it is
};

/// @param links        of the robot description
/// @param base_frame   the link that represents the car: the only robotBaseFrame that is allowed
/// @param max_rate_hz  of the physics steps
/// @throws f1tenth_sim2d::Error naming the element's place, the tag, what was found and what is allowed
OdometryParameters parseOdometryParameters(
  const f1tenth_sim2d::PluginElement & element, const std::vector<std::string> & links, const std::string & base_frame,
  double max_rate_hz);
}  // namespace f1tenth_gazebo_plugins
