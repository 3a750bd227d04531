#include "node/cars/ros_control.h"

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

/// Answers a service whose only answer is whether it worked; says why not.
template <class Response, class Action>
bool attempt(Response & response, const Action & action)
{
  try {
    action();
    response.ok = true;
  } catch (const std::runtime_error & error) {
    ROS_ERROR("%s", error.what());
    response.ok = false;
  }
  return true;
}
}  // namespace

RosControl::RosControl(CarHandle car, CommandInput & commands, bool simulates_pid)
: car_(std::move(car)),
  commands_(commands),
  simulates_pid_(simulates_pid),
  rate_hz_(1.0 / std::max(kLeastPeriod, car_.description().ros_control->control_period_sec))
{
  const auto serve = [this](const std::string & name, auto method) {
    servers_.push_back(car_.node.advertiseService("controller_manager/" + name, method, this));
  };
  serve("list_controllers", &RosControl::list);
  serve("list_controller_types", &RosControl::listTypes);
  serve("load_controller", &RosControl::load);
  serve("unload_controller", &RosControl::unload);
  serve("switch_controller", &RosControl::switchOver);
  serve("reload_controller_libraries", &RosControl::reload);
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

bool RosControl::list(
  controller_manager_msgs::ListControllers::Request & /*request*/,
  controller_manager_msgs::ListControllers::Response & response)
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
  return true;
}

bool RosControl::listTypes(
  controller_manager_msgs::ListControllerTypes::Request & /*request*/,
  controller_manager_msgs::ListControllerTypes::Response & response)
{
  response.types.push_back(kJointStateController);
  for (const auto & type : jointControllerTypes()) {
    response.types.push_back(type.name);
  }
  response.base_classes.assign(response.types.size(), "controller_interface::ControllerBase");
  return true;
}

bool RosControl::load(
  controller_manager_msgs::LoadController::Request & request,
  controller_manager_msgs::LoadController::Response & response)
{
  return attempt(response, [&] {
    if (controllers_.count(request.name) > 0) {
      throw Error("controller " + request.name + ": is loaded already");
    }
    controllers_.emplace(request.name, make(request.name));
  });
}

bool RosControl::unload(
  controller_manager_msgs::UnloadController::Request & request,
  controller_manager_msgs::UnloadController::Response & response)
{
  return attempt(response, [&] {
    const auto found = controllers_.find(request.name);
    if (found == controllers_.end()) {
      throw Error("controller " + request.name + ": is not loaded");
    }
    if (found->second.runs()) {
      throw Error("controller " + request.name + ": cannot be unloaded while it runs");
    }
    controllers_.erase(found);
  });
}

bool RosControl::reload(
  controller_manager_msgs::ReloadControllerLibraries::Request & request,
  controller_manager_msgs::ReloadControllerLibraries::Response & response)
{
  return attempt(response, [&] {
    if (!controllers_.empty() && !request.force_kill) {
      throw Error("controllers are loaded: libraries are reloaded only with force_kill");
    }
    schedule_ = {};
    controllers_.clear();
  });
}

bool RosControl::switchOver(
  controller_manager_msgs::SwitchController::Request & request,
  controller_manager_msgs::SwitchController::Response & response)
{
  return attempt(response, [&] {
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
  });
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
    Names names{kJointStateController};
    std::transform(types.begin(), types.end(), std::back_inserter(names), [](const auto & each) { return each.name; });
    throw Error(
      "controller " + name + ": type " + type + " is unknown; known are " + boost::algorithm::join(names, ", "));
  }
  return makeJointController(name, *found);
}

RosControl::Controller RosControl::makeJointController(const std::string & name, const JointControllerType & type)
{
  Controller controller{type.name, "initialized", nullptr, nullptr};
  const JointController::Listener listener{
    [this] { commands_.noteAnswer(); }, [this](const std::string & why) { commands_.refuse(why); }};
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
    Names names;
    std::transform(
      joints.begin(), joints.end(), std::back_inserter(names), [](const auto & each) { return each.name; });
    throw Error(
      "controller " + controller + ": no joint " + name + " that moves; there are " +
      boost::algorithm::join(names, ", "));
  }
  return *found;
}
}  // namespace f1tenth_sim2d
