#pragma once

#include <ros/node_handle.h>

#include <string>

#include "amcl/localizer.h"

namespace amcl
{
/// The parameters that the node reads at its start. Names and defaults are in the README.
struct NodeParameters
{
  std::string base_frame_id{"base_link"};
  std::string odom_frame_id{"odom"};
  std::string global_frame_id{"map"};
  bool use_map_topic{false};
  bool first_map_only{false};
  bool tf_broadcast{true};
  double transform_tolerance{0.1};  ///< s, how far into the future the transform is stamped
  double save_pose_rate{0.5};       ///< Hz; 0 or less: never
  bool lockstep{false};
  Estimate start;
  LocalizerOptions localizer;
};

/// Warns once of parameters that this stand-in has no use for.
/// @throws OptionError for a parameter of a wrong type or out of range
NodeParameters readParameters(const ros::NodeHandle & node);
}  // namespace amcl
