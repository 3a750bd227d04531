#include <workspace_support/parameter_reader.h>

#include <algorithm>
#include <cmath>

#include "parameter_groups.h"

namespace move_base
{
namespace
{
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

// Those of TEB are the options' own.
void setDefaultsOf(const std::string & planner, NavigatorOptions & navigator)
{
  SpeedLimits & limits = navigator.follower.limits;
  if (planner == "TrajectoryPlannerROS") {
    limits.max_vel_x = 0.5;
    limits.min_vel_x = 0.1;
    limits.max_vel_theta = 1.0;
    limits.acc_lim_x = 2.5;
    navigator.goal_tolerance = {0.1, 0.05};
  } else if (planner == "DWAPlannerROS") {
    limits.max_vel_x = 0.55;
    limits.max_vel_theta = 1.0;
    limits.acc_lim_x = 2.5;
    navigator.goal_tolerance = {0.1, 0.1};
  }
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

void readFollower(ParameterReader & reader, const std::string & name, FollowerOptions & follower)
{
  reader.read(ofPlanner(name, "latency"), follower.latency);
  reader.read(ofPlanner(name, "tracking_distance"), follower.tracking_distance);
  reader.read(ofPlanner(name, "tracking_time"), follower.tracking_time);
  reader.read(ofPlanner(name, "slip_gradient"), follower.slip_gradient);
  reader.read(ofPlanner(name, "understeer_gradient"), follower.limits.understeer_gradient);
  reader.read(ofPlanner(name, "load_transfer"), follower.load_transfer);
  reader.read(ofPlanner(name, "yaw_lag"), follower.yaw_lag);
  reader.read(ofPlanner(name, "stop_clearance"), follower.stop_clearance);
  reader.read(ofPlanner(name, "replan_distance"), follower.replan_distance);
  reader.read(ofPlanner(name, "max_path_deviation"), follower.max_path_deviation);
}

void readGoals(ParameterReader & reader, const std::string & name, NavigatorOptions & navigator)
{
  reader.read(ofPlanner(name, "xy_goal_tolerance"), navigator.goal_tolerance.distance);
  reader.read(ofPlanner(name, "yaw_goal_tolerance"), navigator.goal_tolerance.yaw);
  reader.read(ofPlanner(name, "free_goal_vel"), navigator.free_goal_vel);
  reader.read(ofPlanner(name, "via_xy_tolerance"), navigator.via_tolerance.distance);
  reader.read(ofPlanner(name, "via_yaw_tolerance"), navigator.via_tolerance.yaw);
  reader.read(ofPlanner(name, "race_line"), navigator.race_line);
  reader.read(ofPlanner(name, "coast_time"), navigator.coast_time);
}
}  // namespace

void readGlobalPlanner(ParameterReader & reader, MoveBaseParameters & parameters)
{
  parameters.global_planner = pluginNamespace(reader, "base_global_planner", "navfn/NavfnROS");
  const std::string & name = parameters.global_planner;
  parameters.costmap.allow_unknown = true;
  PlannerOptions & planner = parameters.navigator.planner;
  reader.read(ofPlanner(name, "allow_unknown"), parameters.costmap.allow_unknown);
  reader.read(ofPlanner(name, "allow_reversing"), planner.allow_reversing);
  reader.read(ofPlanner(name, "reverse_penalty"), planner.reverse_penalty);
  reader.read(ofPlanner(name, "direction_penalty"), planner.direction_penalty);
  reader.read(ofPlanner(name, "steering_penalty"), planner.steering_penalty);
  reader.read(ofPlanner(name, "curvature_penalty"), planner.curvature_penalty);
  reader.read(ofPlanner(name, "max_expansions"), planner.max_expansions);
}

void readLocalPlanner(ParameterReader & reader, MoveBaseParameters & parameters)
{
  parameters.local_planner = pluginNamespace(reader, "base_local_planner", "base_local_planner/TrajectoryPlannerROS");
  const std::string & name = parameters.local_planner;
  NavigatorOptions & navigator = parameters.navigator;
  FollowerOptions & follower = navigator.follower;
  setDefaultsOf(name, navigator);
  readSpeedLimits(reader, name, follower.limits);
  readFollower(reader, name, follower);
  reader.read(ofPlanner(name, "min_turning_radius"), navigator.planner.min_turning_radius);
  if (!reader.read(ofPlanner(name, "max_steering_angle"), follower.limits.max_steering_angle)) {
    // The original has the radius only.
    const double needed = std::atan(follower.limits.wheelbase / navigator.planner.min_turning_radius);
    follower.limits.max_steering_angle = std::max(follower.limits.max_steering_angle, needed);
  }
  reader.read(ofPlanner(name, "min_obstacle_dist"), navigator.planner.min_obstacle_dist);
  readGoals(reader, name, navigator);
  reader.read(ofPlanner(name, "odom_topic"), parameters.odom_topic);
  reader.read(ofPlanner(name, "cmd_angle_instead_rotvel"), parameters.cmd_angle_instead_rotvel);
}
}  // namespace move_base
