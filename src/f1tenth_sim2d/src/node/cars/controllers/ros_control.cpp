#include "node/cars/controllers/ros_control.h"

#include <controller_manager_msgs/LoadController.h>
#include <controller_manager_msgs/ReloadControllerLibraries.h>
#include <controller_manager_msgs/UnloadController.h>
#include <ros/console.h>

#include <algorithm>
#include <set>
#include <utility>

#include "f1tenth_sim2d/errors.h"
#include "node/cars/controllers/controller_types.h"

namespace f1tenth_sim2d
{
namespace
{
// More often would not change what a car with an actuation latency does.
constexpr double kLeastPeriod = 0.005;  // s

bool isAmong(const std::vector<std::string> & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// @param answer  takes the request and the response
template <class Service, class Answer>
ros::ServiceServer serve(ros::NodeHandle & car, const std::string & name, const Answer & answer)
{
  const boost::function<bool(typename Service::Request &, typename Service::Response &)> callback =
    [answer](auto & request, auto & response) {
      answer(request, response);
      return true;
    };
  return car.advertiseService("controller_manager/" + name, callback);
}

/// The same for a service whose only answer is whether it worked; logs why not.
template <class Service, class Action>
ros::ServiceServer serveAttempt(ros::NodeHandle & car, const std::string & name, const Action & action)
{
  return serve<Service>(car, name, [action](const auto & request, auto & response) {
    try {
      action(request);
      response.ok = true;
    } catch (const std::runtime_error & error) {
      ROS_ERROR("%s", error.what());
      response.ok = false;
    }
  });
}

void listTypes(controller_manager_msgs::ListControllerTypes::Response & response)
{
  response.types = controllerTypes();
  response.base_classes.assign(response.types.size(), "controller_interface::ControllerBase");
}
}  // namespace

RosControl::RosControl(CarHandle car, CommandInput & commands)
: car_(std::move(car)),
  commands_(commands),
  period_(fromSeconds(std::max(kLeastPeriod, car_.description().ros_control->control_period_sec)))
{
  using namespace controller_manager_msgs;
  servers_ = {
    serve<ListControllers>(car_.node, "list_controllers", [this](auto &, auto & response) { list(response); }),
    serve<ListControllerTypes>(
      car_.node, "list_controller_types", [](auto &, auto & response) { listTypes(response); }),
    serveAttempt<LoadController>(car_.node, "load_controller", [this](auto & wanted) { load(wanted.name); }),
    serveAttempt<UnloadController>(car_.node, "unload_controller", [this](auto & wanted) { unload(wanted.name); }),
    serveAttempt<SwitchController>(car_.node, "switch_controller", [this](auto & wanted) { switchOver(wanted); }),
    serveAttempt<ReloadControllerLibraries>(
      car_.node, "reload_controller_libraries", [this](auto & wanted) { reload(wanted.force_kill); })};
}

void RosControl::beforeStep(Simulation & simulation, CarId car)
{
  const SimTime now = simulation.time();
  if (now < last_) {
    startAnew(now);
  } else if (now < last_ + period_) {
    return;
  }
  last_ = now;
  if (const auto commands = wanted(); !commands.empty()) {
    const double speed = simulation.state(car).velocity.x;
    simulation.command(car, driveCommand(commands, simulation.car(car), simulation.parameters(car), speed));
  }
}

void RosControl::startAnew(SimTime now)
{
  last_ = now;
  for (auto & [name, loaded] : controllers_) {
    if (loaded.runs()) {
      start(loaded);
    }
  }
}

void RosControl::publish(SimTime now)
{
  for (auto & [name, loaded] : controllers_) {
    if (loaded.runs()) {
      loaded.controller->publish(now);
    }
  }
}

std::vector<JointCommand> RosControl::wanted() const
{
  std::vector<JointCommand> commands;
  for (const auto & [name, loaded] : controllers_) {
    if (const auto command = loaded.runs() ? loaded.controller->command() : std::nullopt) {
      commands.push_back(*command);
    }
  }
  return commands;
}

void RosControl::list(controller_manager_msgs::ListControllers::Response & response) const
{
  for (const auto & [name, loaded] : controllers_) {
    controller_manager_msgs::ControllerState state;
    state.name = name;
    state.state = loaded.state;
    state.type = loaded.type;
    state.claimed_resources = {loaded.controller->claim()};
    response.controller.push_back(state);
  }
}

void RosControl::load(const std::string & name)
{
  if (controllers_.count(name) > 0) {
    throw Error("controller " + name + ": is loaded already");
  }
  ControllerSetup setup{name, "", car_, commands_};
  setup.parameters().readRequired("type", setup.type);
  controllers_.emplace(name, Loaded{setup.type, makeController(setup)});
}

void RosControl::unload(const std::string & name)
{
  const auto found = controllers_.find(name);
  if (found == controllers_.end()) {
    throw Error("controller " + name + ": is not loaded");
  }
  if (found->second.runs()) {
    throw Error("controller " + name + ": cannot be unloaded while it runs");
  }
  controllers_.erase(found);
}

void RosControl::reload(bool force)
{
  if (!controllers_.empty() && !force) {
    throw Error("controllers are loaded: libraries are reloaded only with force_kill");
  }
  controllers_.clear();
}

void RosControl::switchOver(const controller_manager_msgs::SwitchController::Request & request)
{
  if (request.strictness == controller_manager_msgs::SwitchController::Request::STRICT) {
    checkSwitch(request.start_controllers, request.stop_controllers);
  }
  // As in ros_control, whatever the strictness.
  checkJoints(request.start_controllers, request.stop_controllers);
  for (const auto & name : request.stop_controllers) {
    if (const auto found = controllers_.find(name); found != controllers_.end() && found->second.runs()) {
      found->second.state = "stopped";
    }
  }
  for (const auto & name : request.start_controllers) {
    if (const auto found = controllers_.find(name); found != controllers_.end() && !found->second.runs()) {
      start(found->second);
    }
  }
}

void RosControl::checkSwitch(const Names & start, const Names & stop) const
{
  for (const auto & name : stop) {
    const auto found = controllers_.find(name);
    if (found == controllers_.end() || !found->second.runs()) {
      throw Error("controller " + name + ": cannot be stopped, it does not run");
    }
  }
  for (const auto & name : start) {
    const auto found = controllers_.find(name);
    if (found == controllers_.end()) {
      throw Error("controller " + name + ": cannot be started, it is not loaded");
    }
    if (found->second.runs() && !isAmong(stop, name)) {
      throw Error("controller " + name + ": cannot be started, it runs already");
    }
  }
}

void RosControl::checkJoints(const Names & start, const Names & stop) const
{
  std::set<std::string> claimed;
  for (const auto & [name, loaded] : controllers_) {
    if (loaded.runs() && !isAmong(stop, name)) {
      const Names joints = loaded.controller->claim().resources;
      claimed.insert(joints.begin(), joints.end());
    }
  }
  for (const auto & name : std::set<std::string>(start.begin(), start.end())) {
    const auto found = controllers_.find(name);
    if (found == controllers_.end() || (found->second.runs() && !isAmong(stop, name))) {
      continue;  // not started, or counted above
    }
    for (const std::string & joint : found->second.controller->claim().resources) {
      if (!claimed.insert(joint).second) {
        throw Error("controller " + name + ": another controller has its joint " + joint);
      }
    }
  }
}

void RosControl::start(Loaded & loaded)
{
  loaded.state = "running";
  loaded.controller->start(last_);
}
}  // namespace f1tenth_sim2d
