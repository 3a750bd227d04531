#pragma once

#include <ros/node_handle.h>

#include <string>

#include "gmapping/slam_options.h"

namespace gmapping
{
/// The parameters that the node reads at its start. Names and defaults are in the README.
struct NodeParameters
{
  std::string base_frame{"base_link"};
  std::string map_frame{"map"};
  std::string odom_frame{"odom"};
  int throttle_scans{1};
  double map_update_interval{5.0};        ///< s between maps
  double transform_publish_period{0.05};  ///< s; 0: never
  double tf_delay{0.05};                  ///< s, how far into the future the transform is stamped
  bool lockstep{false};
  SlamOptions slam;
};

/// Warns once of parameters that this stand-in has no use for.
/// @throws OptionError for a parameter of a wrong type or out of range
NodeParameters readParameters(const ros::NodeHandle & node);
}  // namespace gmapping
