#include "node/cars/controllers/joint_controller.h"

#include <std_msgs/Float64.h>
#include <std_msgs/Float64MultiArray.h>

#include <functional>

#include "node/cars/joint_state.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr std::uint32_t kJointQueueSize = 10;

template <class Message>
ros::Subscriber subscribe(ros::NodeHandle node, const std::function<void(const Message &)> & take)
{
  return node.subscribe<Message>(
    "command", kJointQueueSize, [take](const typename Message::ConstPtr & message) { take(*message); },
    ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

std::vector<std::string> jointNames(const ControllerSetup & setup, bool is_group)
{
  workspace_support::ParameterReader parameters = setup.parameters();
  std::vector<std::string> names(1);
  if (!is_group) {
    parameters.readRequired("joint", names.front());
  } else if (!parameters.read("joints", names) || names.empty()) {
    parameters.fail("joints", "a list of names");
  }
  return names;
}
}  // namespace

JointController::JointController(
  const ControllerSetup & setup, const std::string & interface, JointCommand::Kind kind, bool is_group)
: interface_(interface), car_(setup.car), commands_(setup.commands)
{
  for (const std::string & name : jointNames(setup, is_group)) {
    joints_.push_back(setup.joint(name, kind, is_group ? name + "/pid" : "pid"));
  }
  values_.resize(joints_.size());
  subscriber_ =
    is_group
      ? subscribe<std_msgs::Float64MultiArray>(setup.node(), [this](const auto & message) { take(message.data); })
      : subscribe<std_msgs::Float64>(setup.node(), [this](const auto & message) { take({message.data}); });
}

Controller::Claims JointController::claims() const
{
  std::vector<std::string> names;
  names.reserve(joints_.size());
  for (const ControlledJoint & joint : joints_) {
    names.push_back(joint.description().name);
  }
  return {claimOf(interface_, names)};
}

void JointController::start(SimTime /*now*/)
{
  values_.assign(joints_.size(), 0.0);
  for (ControlledJoint & joint : joints_) {
    joint.restart();
  }
}

std::vector<JointCommand> JointController::update(SimTime /*now*/, double dt)
{
  std::vector<JointCommand> commands;
  commands.reserve(joints_.size());
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointState state = jointState(joints_[i].description(), car_.simulation, car_.id);
    commands.push_back(joints_[i].command(values_[i], state.velocity, dt));
  }
  return commands;
}

void JointController::take(const std::vector<double> & values)
{
  const std::string objection = objectionTo(values);
  if (objection.empty()) {
    values_ = values;
  }
  commands_.noteTold(objection);
}

std::string JointController::objectionTo(const std::vector<double> & values) const
{
  if (values.size() != joints_.size()) {
    return "a command has " + std::to_string(values.size()) + " values, must have one for each of " +
           std::to_string(joints_.size()) + " joints";
  }
  std::string objection;
  for (std::size_t i = 0; i < joints_.size() && objection.empty(); ++i) {
    objection = joints_[i].objectionTo(values[i]);
  }
  return objection;
}
}  // namespace f1tenth_sim2d
