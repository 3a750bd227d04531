#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "navigator.h"

namespace move_base
{
/// The parameters that the node reads at its start. Names and defaults are in the README.
struct MoveBaseParameters
{
  std::string global_frame{"map"};
  std::string local_frame{"odom"};
  std::string base_frame{"base_link"};
  std::string map_topic{"map"};
  std::string odom_topic{"odom"};
  std::string scan_topic{"scan"};
  std::string global_planner{"NavfnROS"};             ///< namespace of its parameters and topics
  std::string local_planner{"TrajectoryPlannerROS"};  ///< the same
  double transform_tolerance{0.3};                    ///< s, a pose of the car older than this is stale
  double sensor_timeout{0.5};                         ///< s, a scan or odometry older than this is stale
  double controller_period{0.05};                     ///< s; 0: every period of the lockstep
  bool cmd_angle_instead_rotvel{false};               ///< whether commands contain the angle of the wheels
  bool shutdown_costmaps{false};                      ///< whether scans are ignored without a goal
  bool lockstep{false};
  std::string lockstep_after;            ///< participant that acts before this one; empty: none
  double global_publish_frequency{0.0};  ///< Hz; 0: costmaps for new subscribers only, footprints never
  double local_publish_frequency{0.0};   ///< Hz; the same
  bool global_always_whole{false};       ///< whether the costmap is sent whole when a part has changed
  bool local_always_whole{false};
  double local_width{10.0};       ///< m
  double local_height{10.0};      ///< m
  double local_resolution{0.05};  ///< m
  Inflation local_inflation;      ///< of what is shown
  std::vector<Vec2> footprint;
  double footprint_padding{0.01};  ///< m
  CostmapOptions costmap;
  NavigatorOptions navigator;
};

/// Warns once of parameters that this stand-in has no use for.
/// @throws OptionError for a parameter of a wrong type or out of range
MoveBaseParameters readParameters(const ros::NodeHandle & node);
}  // namespace move_base
