#include "node/cars/ros_control.h"

#include <controller_manager_msgs/LoadController.h>
#include <controller_manager_msgs/ReloadControllerLibraries.h>
#include <controller_manager_msgs/UnloadController.h>
#include <ros/console.h>
#include <workspace_support/parameter_reader.h>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <set>
#include <utility>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
using workspace_support::ParameterReader;

const std::string kJointStateController = "joint_state_controller/JointStateController";
// More often would not change what a car with an actuation latency does.
constexpr double kLeastPeriod = 0.005;  // s

bool isAmong(const std::vector<std::string> & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Things>
std::string namesOf(const Things & things)
{
  std::vector<std::string> names;
  for (const auto & each : things) {
    names.push_back(each.name);
  }
  return boost::algorithm::join(names, ", ");
}

/// Whether there are any.
bool readGains(const ros::NodeHandle & node, PidGains & gains)
{
  ParameterReader reader(node);
  reader.read("i_clamp", gains.i_clamp, workspace_support::atLeast(0.0));
  const bool has_p = reader.read("p", gains.p);
  const bool has_i = reader.read("i", gains.i);
  const bool has_d = reader.read("d", gains.d);
  return has_p || has_i || has_d;
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

/// The same of a service whose only answer is whether it worked; says why not.
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
  response.types.push_back(kJointStateController);
  for (const auto & type : jointControllerTypes()) {
    response.types.push_back(type.name);
  }
  response.base_classes.assign(response.types.size(), "controller_interface::ControllerBase");
}
}  // namespace

RosControl::RosControl(CarHandle car, CommandInput & commands, bool simulates_pid)
: car_(std::move(car)),
  commands_(commands),
  simulates_pid_(simulates_pid),
  rate_hz_(1.0 / std::max(kLeastPeriod, car_.description().ros_control->control_period_sec))
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

void RosControl::update(SimTime now, bool /*anyway*/)
{
  if (now < last_) {
    schedule_.restart();
  }
  const double dt = static_cast<double>(now - last_) * 1e-9;
  last_ = now;
  if (const auto commands = wanted(dt); !commands.empty()) {
    const auto & simulation = car_.simulation;
    commands_.apply(
      driveCommand(commands, car_.description(), simulation.parameters(car_.id), simulation.state(car_.id).velocity.x));
  }
  schedule_.run(now);
}

std::vector<JointCommand> RosControl::wanted(double dt)
{
  std::vector<JointCommand> commands;
  for (auto & [name, controller] : controllers_) {
    if (controller.joint && controller.runs()) {
      commands.push_back(controller.joint->command(speedOf(controller.joint->joint()), dt));
    }
  }
  return commands;
}

double RosControl::speedOf(const JointDescription & joint) const
{
  const auto & speeds = car_.simulation.state(car_.id).wheel_speeds;
  const auto wheel = static_cast<std::size_t>(joint.role);
  return wheel < speeds.size() ? joint.direction * speeds[wheel] : 0.0;
}

void RosControl::list(controller_manager_msgs::ListControllers::Response & response) const
{
  for (const auto & [name, controller] : controllers_) {
    controller_manager_msgs::ControllerState state;
    state.name = name;
    state.state = controller.state;
    state.type = controller.type;
    controller_manager_msgs::HardwareInterfaceResources claimed;
    claimed.hardware_interface =
      controller.joint ? controller.joint->type().interface : "hardware_interface::JointStateInterface";
    if (controller.joint) {
      claimed.resources.push_back(controller.joint->joint().name);
    }
    state.claimed_resources.push_back(claimed);
    response.controller.push_back(state);
  }
}

void RosControl::load(const std::string & name)
{
  if (controllers_.count(name) > 0) {
    throw Error("controller " + name + ": is loaded already");
  }
  controllers_.emplace(name, make(name));
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
  schedule_ = {};
  controllers_.clear();
}

void RosControl::switchOver(const controller_manager_msgs::SwitchController::Request & request)
{
  if (request.strictness == controller_manager_msgs::SwitchController::Request::STRICT) {
    checkSwitch(request.start_controllers, request.stop_controllers);
  }
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
  std::set<std::string> claimed;
  for (const auto & [name, controller] : controllers_) {
    if (controller.joint && controller.runs() && !isAmong(stop, name)) {
      claimed.insert(controller.joint->joint().name);
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
    if (found->second.joint && !claimed.insert(found->second.joint->joint().name).second) {
      throw Error("controller " + name + ": another controller has its joint " + found->second.joint->joint().name);
    }
  }
}

void RosControl::start(Controller & controller)
{
  controller.state = "running";
  if (controller.joint) {
    controller.joint->start();
  }
}

RosControl::Controller RosControl::make(const std::string & name)
{
  ParameterReader reader({car_.node, name});
  std::string type;
  reader.readRequired("type", type);
  if (type == kJointStateController) {
    double rate_hz = 50.0;
    reader.read("publish_rate", rate_hz, workspace_support::positive());
    Controller controller{type, "initialized", nullptr, nullptr};
    controller.joint_states =
      std::make_unique<JointStatesOutput>(car_, "joint_states", rate_hz, car_.description().mechanism);
    schedule_.add(
      periodOf(rate_hz),
      [this, name](SimTime now) {
        const auto found = controllers_.find(name);
        if (found != controllers_.end() && found->second.joint_states && found->second.runs()) {
          found->second.joint_states->update(now, false);
        }
      },
      last_);
    return controller;
  }
  const auto & types = jointControllerTypes();
  const auto found = std::find_if(types.begin(), types.end(), [&](const auto & each) { return each.name == type; });
  if (found == types.end()) {
    throw Error(
      "controller " + name + ": type " + type + " is unknown; known are " + kJointStateController + ", " +
      namesOf(types));
  }
  return makeJointController(name, *found);
}

RosControl::Controller RosControl::makeJointController(const std::string & name, const JointControllerType & type)
{
  Controller controller{type.name, "initialized", nullptr, nullptr};
  const JointController::Listener listener{
    [this] { commands_.noteAnswer(); }, [this] { commands_.noteAccepted(); },
    [this](const std::string & why) { commands_.refuse(why); }};
  controller.joint =
    std::make_unique<JointController>(type, joint(name), car_.description().wheel_radius, car_.node, name, listener);
  useGains(name, *controller.joint);
  return controller;
}

void RosControl::useGains(const std::string & name, JointController & controller) const
{
  PidGains gains;
  if (!readGains(ros::NodeHandle(car_.node, name + "/pid"), gains)) {
    const std::string of_joint = "gazebo_ros_control/pid_gains/" + controller.joint().name;
    if (!readGains(ros::NodeHandle(car_.node, of_joint), gains)) {
      return;
    }
  }
  if (simulates_pid_ && controller.type().kind == JointCommand::Kind::kVelocity) {
    controller.simulate(gains);
  } else {
    ROS_WARN(
      "controller %s: its pid gains are not simulated, %s follows as fast as the car can%s", name.c_str(),
      controller.joint().name.c_str(), simulates_pid_ ? "" : " (the simulator's parameter simulate_pid: true does)");
  }
}

const JointDescription & RosControl::joint(const std::string & controller) const
{
  std::string name;
  ParameterReader({car_.node, controller}).readRequired("joint", name);
  const auto & joints = car_.description().mechanism;
  const auto found = std::find_if(joints.begin(), joints.end(), [&](const auto & each) { return each.name == name; });
  if (found == joints.end()) {
    throw Error("controller " + controller + ": no joint " + name + " that moves; there are " + namesOf(joints));
  }
  return *found;
}
}  // namespace f1tenth_sim2d
