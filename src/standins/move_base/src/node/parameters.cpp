#include "parameters.h"

#include <workspace_support/parameter_reader.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry/errors.h"

namespace move_base
{
namespace
{
using workspace_support::ParameterReader;

// "teb_local_planner/TebLocalPlannerROS" has its parameters in ~TebLocalPlannerROS.
std::string pluginNamespace(ParameterReader & reader, const std::string & parameter, std::string plugin)
{
  reader.read(parameter, plugin);
  return plugin.substr(plugin.rfind('/') + 1);
}

// Where the original looks for a planner's parameter; and, for short, right under the node.
std::vector<std::string> ofPlanner(const std::string & planner, const std::string & name)
{
  return {planner + "/" + name, name};
}

// The layered costmap's place of a parameter, the older one, and, for short, right under the node.
std::vector<std::string> ofCostmap(const std::string & costmap, const std::string & layer, const std::string & name)
{
  return {costmap + "/" + layer + "/" + name, costmap + "/" + name, name};
}

std::vector<std::string> ofCostmap(const std::string & costmap, const std::string & name)
{
  return {costmap + "/" + name, name};
}

void readFrames(ParameterReader & reader, MoveBaseParameters & parameters)
{
  reader.read("global_costmap/global_frame", parameters.global_frame);
  reader.read("local_costmap/global_frame", parameters.local_frame);
  reader.read(ofCostmap("global_costmap", "robot_base_frame"), parameters.base_frame);
  reader.read(ofCostmap("global_costmap", "transform_tolerance"), parameters.transform_tolerance);
}

// The first lidar among the observation sources of the original's obstacle layer.
void readScanTopic(ParameterReader & reader, const std::string & costmap, MoveBaseParameters & parameters)
{
  std::string sources;
  reader.read(ofCostmap(costmap, "obstacle_layer", "observation_sources"), sources);
  std::istringstream names(sources);
  for (std::string source; names >> source;) {
    std::string type;
    std::string topic = source;
    reader.read(ofCostmap(costmap, "obstacle_layer", source + "/data_type"), type);
    reader.read(ofCostmap(costmap, "obstacle_layer", source + "/topic"), topic);
    if (type == "LaserScan") {
      parameters.scan_topic = topic;
      return;
    }
  }
}

void readTopics(ParameterReader & reader, MoveBaseParameters & parameters)
{
  reader.read(ofCostmap("global_costmap", "static_layer", "map_topic"), parameters.map_topic);
  readScanTopic(reader, "global_costmap", parameters);
  readScanTopic(reader, "local_costmap", parameters);
}

void readCostmaps(ParameterReader & reader, MoveBaseParameters & parameters)
{
  parameters.footprint = defaultFootprint();
  reader.read(ofCostmap("global_costmap", "footprint"), parameters.footprint);
  reader.read(ofCostmap("global_costmap", "footprint_padding"), parameters.footprint_padding);
  reader.read("global_costmap/publish_frequency", parameters.global_publish_frequency);
  reader.read("local_costmap/publish_frequency", parameters.local_publish_frequency);
  reader.read("local_costmap/width", parameters.local_width);
  reader.read("local_costmap/height", parameters.local_height);

  CostmapOptions & costmap = parameters.costmap;
  reader.read(ofCostmap("global_costmap", "static_layer", "lethal_cost_threshold"), costmap.lethal_cost_threshold);
  reader.read(ofCostmap("global_costmap", "inflation_layer", "inflation_radius"), costmap.inflation_radius);
  reader.read(ofCostmap("global_costmap", "inflation_layer", "cost_scaling_factor"), costmap.cost_scaling_factor);
  reader.read("clearance_weight", costmap.clearance_weight);
  reader.read(ofCostmap("local_costmap", "obstacle_layer", "obstacle_range"), costmap.live.obstacle_range);
  reader.read(ofCostmap("local_costmap", "obstacle_layer", "raytrace_range"), costmap.live.raytrace_range);
  reader.read("wall_tolerance", costmap.live.wall_tolerance);
}

void readGlobalPlanner(ParameterReader & reader, const std::string & name, MoveBaseParameters & parameters)
{
  PlannerOptions & planner = parameters.navigator.planner;
  reader.read(ofPlanner(name, "allow_unknown"), parameters.costmap.allow_unknown);
  reader.read(ofPlanner(name, "allow_reversing"), planner.allow_reversing);
  reader.read(ofPlanner(name, "reverse_penalty"), planner.reverse_penalty);
  reader.read(ofPlanner(name, "direction_penalty"), planner.direction_penalty);
  reader.read(ofPlanner(name, "steering_penalty"), planner.steering_penalty);
  reader.read(ofPlanner(name, "curvature_penalty"), planner.curvature_penalty);
  reader.read(ofPlanner(name, "max_expansions"), planner.max_expansions);
}

void readSpeedLimits(ParameterReader & reader, const std::string & name, SpeedLimits & limits)
{
  reader.read(ofPlanner(name, "max_vel_x"), limits.max_vel_x);
  reader.read(ofPlanner(name, "max_vel_x_backwards"), limits.max_vel_x_backwards);
  reader.read(ofPlanner(name, "max_vel_theta"), limits.max_vel_theta);
  reader.read(ofPlanner(name, "min_vel_x"), limits.min_vel_x);
  reader.read(ofPlanner(name, "acc_lim_x"), limits.acc_lim_x);
  limits.dec_lim_x = limits.acc_lim_x;
  reader.read(ofPlanner(name, "dec_lim_x"), limits.dec_lim_x);
  reader.read(ofPlanner(name, "braking_power"), limits.braking_power);
  reader.read(ofPlanner(name, "max_lateral_acceleration"), limits.max_lateral_acceleration);
  reader.read(ofPlanner(name, "max_steering_rate"), limits.max_steering_rate);
  reader.read(ofPlanner(name, "wheelbase"), limits.wheelbase);
  reader.read(ofPlanner(name, "full_speed_clearance"), limits.full_speed_clearance);
  reader.read(ofPlanner(name, "slowest_clearance"), limits.slowest_clearance);
}

void readLocalPlanner(ParameterReader & reader, const std::string & name, NavigatorOptions & navigator)
{
  FollowerOptions & follower = navigator.follower;
  readSpeedLimits(reader, name, follower.limits);
  reader.read(ofPlanner(name, "latency"), follower.latency);
  reader.read(ofPlanner(name, "tracking_distance"), follower.tracking_distance);
  reader.read(ofPlanner(name, "tracking_time"), follower.tracking_time);
  reader.read(ofPlanner(name, "slip_gradient"), follower.slip_gradient);
  reader.read(ofPlanner(name, "understeer_gradient"), follower.understeer_gradient);
  reader.read(ofPlanner(name, "load_transfer"), follower.load_transfer);
  reader.read(ofPlanner(name, "yaw_lag"), follower.yaw_lag);
  reader.read(ofPlanner(name, "stop_clearance"), follower.stop_clearance);
  reader.read(ofPlanner(name, "replan_distance"), follower.replan_distance);
  reader.read(ofPlanner(name, "max_path_deviation"), follower.max_path_deviation);

  reader.read(ofPlanner(name, "min_turning_radius"), navigator.planner.min_turning_radius);
  if (!reader.read(ofPlanner(name, "max_steering_angle"), follower.max_steering_angle)) {
    // The original knows the radius alone.
    const double needed = std::atan(follower.limits.wheelbase / navigator.planner.min_turning_radius);
    follower.max_steering_angle = std::max(follower.max_steering_angle, needed);
  }
  reader.read(ofPlanner(name, "min_obstacle_dist"), navigator.planner.min_obstacle_dist);
  reader.read(ofPlanner(name, "xy_goal_tolerance"), navigator.goal_tolerance.distance);
  reader.read(ofPlanner(name, "yaw_goal_tolerance"), navigator.goal_tolerance.yaw);
  reader.read(ofPlanner(name, "free_goal_vel"), navigator.free_goal_vel);
  reader.read(ofPlanner(name, "via_xy_tolerance"), navigator.via_tolerance.distance);
  reader.read(ofPlanner(name, "via_yaw_tolerance"), navigator.via_tolerance.yaw);
  reader.read(ofPlanner(name, "race_line"), navigator.race_line);
  reader.read(ofPlanner(name, "coast_time"), navigator.coast_time);
}

void readMoveBase(ParameterReader & reader, MoveBaseParameters & parameters)
{
  reader.read("lockstep", parameters.lockstep);
  reader.read("lockstep_after", parameters.lockstep_after);
  double controller_frequency = 20.0;
  const bool told = reader.read("controller_frequency", controller_frequency, workspace_support::positive());
  if (told || !parameters.lockstep) {
    parameters.controller_period = 1.0 / controller_frequency;
  } else {
    parameters.controller_period = 0.0;
  }
  reader.read("sensor_timeout", parameters.sensor_timeout);
  reader.read("shutdown_costmaps", parameters.shutdown_costmaps);

  NavigatorOptions & navigator = parameters.navigator;
  reader.read("planner_frequency", navigator.planner_frequency);
  reader.read("planner_patience", navigator.planner_patience);
  reader.read("controller_patience", navigator.controller_patience);
  reader.read("max_planning_retries", navigator.max_planning_retries);
  reader.read("oscillation_timeout", navigator.oscillation_timeout);
  reader.read("oscillation_distance", navigator.oscillation_distance);
  reader.read("recovery_behavior_enabled", navigator.recovery_behavior_enabled);
  reader.read("clearing_rotation_allowed", navigator.clearing_rotation_allowed);
  reader.read("conservative_reset_dist", navigator.conservative_reset_dist);
}
}  // namespace

MoveBaseParameters readParameters(const ros::NodeHandle & node)
{
  ParameterReader reader(node);
  MoveBaseParameters parameters;
  readMoveBase(reader, parameters);
  readFrames(reader, parameters);
  readTopics(reader, parameters);
  readCostmaps(reader, parameters);
  parameters.global_planner = pluginNamespace(reader, "base_global_planner", "navfn/NavfnROS");
  parameters.local_planner = pluginNamespace(reader, "base_local_planner", "base_local_planner/TrajectoryPlannerROS");
  readGlobalPlanner(reader, parameters.global_planner, parameters);
  readLocalPlanner(reader, parameters.local_planner, parameters.navigator);
  reader.read(ofPlanner(parameters.local_planner, "odom_topic"), parameters.odom_topic);
  reader.read(ofPlanner(parameters.local_planner, "cmd_angle_instead_rotvel"), parameters.cmd_angle_instead_rotvel);
  reader.check([&] {
    parameters.costmap.validate();
    parameters.navigator.validate();
  });
  reader.warnOfUnused();
  return parameters;
}
}  // namespace move_base
