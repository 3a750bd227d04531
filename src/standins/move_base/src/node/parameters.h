#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "move_base/control/navigator.h"
#include "planners.h"

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
  double wheelbase{0.3302};                           ///< m
  bool cmd_angle_instead_rotvel{false};               ///< whether commands contain the angle of the wheels
  int max_expansions{150000};                         ///< of the searches for a plan that make_plan answers with
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
  std::vector<Vec2> footprint;
  double footprint_padding{0.01};  ///< m
  CostmapOptions costmap;
  NavigatorOptions navigator;
};

/// What the node is made of.
struct MoveBaseSetup
{
  MoveBaseParameters parameters;
  std::unique_ptr<GlobalPlanner> global_planner;
  std::unique_ptr<LocalPlanner> local_planner;
};

/// Warns once of parameters that neither this stand-in nor the planners have a use for.
/// @throws OptionError for a parameter of a wrong type or out of range, or planners that cannot be loaded
MoveBaseSetup readSetup(const ros::NodeHandle & node, Planners & planners);
/// The part that the costmaps have. @throws OptionError
void readCostmaps(workspace_support::ParameterReader & reader, MoveBaseParameters & parameters);
}  // namespace move_base
