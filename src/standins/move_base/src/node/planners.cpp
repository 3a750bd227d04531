#include "planners.h"

#include <workspace_support/errors.h>

#include <set>

#include "move_base/control/path_follower.h"
#include "move_base/planner_parameters.h"
#include "move_base/planning/way_planner.h"

namespace move_base
{
namespace
{
// Packages of the original's planners, for which the plain ones stand in.
const std::set<std::string> kOfTheOriginal{"base_local_planner",  "carrot_planner", "dwa_local_planner",
                                           "eband_local_planner", "global_planner", "navfn",
                                           "teb_local_planner"};

std::string packageOf(const std::string & type)
{
  return type.substr(0, type.rfind('/'));
}

// Defaults of the original planner of that name; those of TEB are the options' own.
PathFollowerOptions defaultsOf(const std::string & planner)
{
  PathFollowerOptions options;
  if (planner == "TrajectoryPlannerROS") {
    options.max_vel_x = 0.5;
    options.min_vel_x = 0.1;
    options.max_vel_theta = 1.0;
    options.acc_lim_x = 2.5;
    options.xy_goal_tolerance = 0.1;
    options.yaw_goal_tolerance = 0.05;
  } else if (planner == "DWAPlannerROS") {
    options.max_vel_x = 0.55;
    options.max_vel_theta = 1.0;
    options.acc_lim_x = 2.5;
    options.xy_goal_tolerance = 0.1;
    options.yaw_goal_tolerance = 0.1;
  }
  return options;
}

PathFollowerOptions readFollower(const PlannerSetup & setup)
{
  PathFollowerOptions options = defaultsOf(setup.local_planner);
  const auto read = [&](const std::string & name, double & value) {
    setup.parameters.read(ofPlanner(setup.local_planner, name), value);
  };
  readSpeeds(setup, options.max_vel_x, options.min_vel_x);
  read("max_vel_x_backwards", options.max_vel_x_backwards);
  read("max_vel_theta", options.max_vel_theta);
  read("acc_lim_x", options.acc_lim_x);
  read("max_lateral_acceleration", options.max_lateral_acceleration);
  read("stop_clearance", options.stop_clearance);
  read("xy_goal_tolerance", options.xy_goal_tolerance);
  read("yaw_goal_tolerance", options.yaw_goal_tolerance);
  readSteering(setup, options.wheelbase, options.max_steering_angle);
  return options;
}
}  // namespace

template <class Plugin>
class_loader::ClassLoader::UniquePtr<Plugin> Planners::load(
  const std::string & parameter, const std::string & type, const PlannerSetup & setup)
{
  const std::string package = packageOf(type);
  const std::string library = "lib" + package + "_planners.so";
  try {
    auto & loader = libraries_[library];
    if (!loader) {
      loader = std::make_unique<class_loader::ClassLoader>(library);
    }
    return loader->createUniqueInstance<Plugin>(package + "::" + type.substr(type.rfind('/') + 1));
  } catch (const class_loader::ClassLoaderException & error) {
    setup.parameters.fail(
      parameter, "PACKAGE/CLASS of a library libPACKAGE_planners.so, or a planner of the original (" +
                   std::string(error.what()) + ")");
  }
}

std::unique_ptr<GlobalPlanner> Planners::makeGlobal(const std::string & type, const PlannerSetup & setup)
{
  if (kOfTheOriginal.count(packageOf(type)) == 0) {
    return load<GlobalPlannerPlugin>("base_global_planner", type, setup)->create(setup);
  }
  const PlannerOptions options = readWayPlanner(setup);
  setup.parameters.check([&] { options.validate(); });
  return std::make_unique<WayPlanner>(options);
}

std::unique_ptr<LocalPlanner> Planners::makeLocal(const std::string & type, const PlannerSetup & setup)
{
  if (kOfTheOriginal.count(packageOf(type)) == 0) {
    return load<LocalPlannerPlugin>("base_local_planner", type, setup)->create(setup);
  }
  const PathFollowerOptions options = readFollower(setup);
  setup.parameters.check([&] { options.validate(); });
  return std::make_unique<PathFollower>(options);
}
}  // namespace move_base
