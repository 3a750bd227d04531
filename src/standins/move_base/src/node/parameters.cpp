#include "parameters.h"

#include <ros/console.h>
#include <workspace_support/errors.h>
#include <workspace_support/parameter_reader.h>

#include "move_base/planner_parameters.h"

namespace move_base
{
namespace
{
// A behaviour of a list as the original reads it; nothing for one that does not exist here.
std::optional<RecoveryBehavior> recoveryOf(ParameterReader & reader, const PluginName & plugin)
{
  const std::string kind = plugin.type.substr(plugin.type.rfind('/') + 1);
  if (kind == "ClearCostmapRecovery") {
    double distance = 3.0;
    reader.read(plugin.name + "/reset_distance", distance, atLeast(0.0));
    return RecoveryBehavior{plugin.name, RecoveryBehavior::Kind::kForget, distance};
  }
  if (kind == "RotateRecovery") {
    return RecoveryBehavior{plugin.name, RecoveryBehavior::Kind::kBackUp};
  }
  ROS_WARN("The recovery behavior %s is left out: there is no %s here", plugin.name.c_str(), plugin.type.c_str());
  return std::nullopt;
}

void readRecovery(ParameterReader & reader, NavigatorOptions & navigator)
{
  reader.read("recovery_behavior_enabled", navigator.recovery_behavior_enabled);
  bool may_move = true;
  double conservative_distance = 3.0;
  reader.read("clearing_rotation_allowed", may_move);
  reader.read("conservative_reset_dist", conservative_distance, atLeast(0.0));
  navigator.recoveries = defaultRecoveries(conservative_distance, may_move);

  bool backs_up = false;
  reader.read("recovery_backs_up", backs_up);
  std::vector<PluginName> plugins;
  if (!reader.read("recovery_behaviors", plugins)) {
    return;
  }
  navigator.recoveries.clear();
  for (const PluginName & plugin : plugins) {
    if (const auto behavior = recoveryOf(reader, plugin)) {
      navigator.recoveries.push_back(*behavior);
    }
  }
  if (backs_up) {
    navigator.recoveries = withBackingUp(navigator.recoveries);
  }
}

void readMoveBase(ParameterReader & reader, MoveBaseParameters & parameters)
{
  reader.read("lockstep", parameters.lockstep);
  reader.read("lockstep_after", parameters.lockstep_after);
  double controller_frequency = 20.0;
  const bool told = reader.read("controller_frequency", controller_frequency, positive());
  if (told || !parameters.lockstep) {
    parameters.controller_period = 1.0 / controller_frequency;
  } else {
    parameters.controller_period = 0.0;
  }
  reader.read("sensor_timeout", parameters.sensor_timeout, positive());
  reader.read("shutdown_costmaps", parameters.shutdown_costmaps);

  NavigatorOptions & navigator = parameters.navigator;
  reader.read("planner_frequency", navigator.planner_frequency);
  reader.read("planner_patience", navigator.planner_patience);
  reader.read("controller_patience", navigator.controller_patience);
  reader.read("max_planning_retries", navigator.max_planning_retries);
  reader.read("oscillation_timeout", navigator.oscillation_timeout);
  reader.read("oscillation_distance", navigator.oscillation_distance);
  readRecovery(reader, navigator);
}
// "teb_local_planner/TebLocalPlannerROS" has its parameters in ~TebLocalPlannerROS.
std::string namespaceOf(const std::string & plugin)
{
  return plugin.substr(plugin.rfind('/') + 1);
}

// Those of the planners' parameters that are the node's business.
void readPlanners(const PlannerSetup & setup, MoveBaseParameters & parameters)
{
  ParameterReader & reader = setup.parameters;
  parameters.costmap.allow_unknown = true;
  reader.read(ofPlanner(setup.global_planner, "allow_unknown"), parameters.costmap.allow_unknown);
  reader.read(ofPlanner(setup.global_planner, "max_expansions"), parameters.max_expansions);
  reader.read(ofPlanner(setup.local_planner, "max_vel_x_backwards"), parameters.navigator.backing_speed);
  reader.read(ofPlanner(setup.local_planner, "wheelbase"), parameters.wheelbase);
  reader.read(ofPlanner(setup.local_planner, "odom_topic"), parameters.odom_topic);
  reader.read(ofPlanner(setup.local_planner, "cmd_angle_instead_rotvel"), parameters.cmd_angle_instead_rotvel);
}
}  // namespace

MoveBaseSetup readSetup(const ros::NodeHandle & node, Planners & planners)
{
  ParameterReader reader(node);
  MoveBaseSetup result;
  MoveBaseParameters & parameters = result.parameters;
  readMoveBase(reader, parameters);
  readCostmaps(reader, parameters);
  std::string global = "navfn/NavfnROS";
  std::string local = "base_local_planner/TrajectoryPlannerROS";
  reader.read("base_global_planner", global);
  reader.read("base_local_planner", local);
  parameters.global_planner = namespaceOf(global);
  parameters.local_planner = namespaceOf(local);
  const PlannerSetup setup{parameters.global_planner, parameters.local_planner, reader};
  readPlanners(setup, parameters);
  reader.check([&] {
    parameters.costmap.validate();
    parameters.navigator.validate();
  });
  result.global_planner = planners.makeGlobal(global, setup);
  result.local_planner = planners.makeLocal(local, setup);
  std::vector<std::string> of_original;
  reader.read("for_the_original", of_original);
  reader.ignore(of_original);
  // Parameters of the planners are warned of one by one.
  reader.warnOfUnused({parameters.global_planner + "/", parameters.local_planner + "/"});
  return result;
}
}  // namespace move_base
