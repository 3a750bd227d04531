#include "parameters.h"

#include <ros/console.h>
#include <workspace_support/errors.h>
#include <workspace_support/parameter_reader.h>

#include "parameter_groups.h"

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
}  // namespace

MoveBaseParameters readParameters(const ros::NodeHandle & node)
{
  ParameterReader reader(node);
  MoveBaseParameters parameters;
  readMoveBase(reader, parameters);
  readCostmaps(reader, parameters);
  readGlobalPlanner(reader, parameters);
  readLocalPlanner(reader, parameters);
  reader.check([&] {
    parameters.costmap.validate();
    parameters.navigator.validate();
  });
  std::vector<std::string> of_original;
  reader.read("for_the_original", of_original);
  reader.ignore(of_original);
  // Parameters of the original's planners are warned of one by one.
  reader.warnOfUnused({parameters.global_planner + "/", parameters.local_planner + "/"});
  return parameters;
}
}  // namespace move_base
