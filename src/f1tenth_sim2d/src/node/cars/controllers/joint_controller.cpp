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

std::vector<std::string> jointNames(const JointControllerType & type, const ControllerSetup & setup)
{
  workspace_support::ParameterReader parameters = setup.parameters();
  std::vector<std::string> names(1);
  if (!type.is_group) {
    parameters.readRequired("joint", names.front());
  } else if (!parameters.read("joints", names) || names.empty()) {
    parameters.fail("joints", "a list of names");
  }
  return names;
}
}  // namespace

const std::vector<JointControllerType> & jointControllerTypes()
{
  using Kind = JointCommand::Kind;
  const std::string velocity = "hardware_interface::VelocityJointInterface";
  const std::string position = "hardware_interface::PositionJointInterface";
  const std::string effort = "hardware_interface::EffortJointInterface";
  static const std::vector<JointControllerType> types{
    {"velocity_controllers/JointVelocityController", velocity, Kind::kVelocity, false},
    {"velocity_controllers/JointPositionController", velocity, Kind::kPosition, false},
    {"velocity_controllers/JointGroupVelocityController", velocity, Kind::kVelocity, true},
    {"position_controllers/JointPositionController", position, Kind::kPosition, false},
    {"position_controllers/JointGroupPositionController", position, Kind::kPosition, true},
    {"effort_controllers/JointEffortController", effort, Kind::kEffort, false},
    {"effort_controllers/JointVelocityController", effort, Kind::kVelocity, false},
    {"effort_controllers/JointPositionController", effort, Kind::kPosition, false},
    {"effort_controllers/JointGroupEffortController", effort, Kind::kEffort, true},
    {"effort_controllers/JointGroupPositionController", effort, Kind::kPosition, true},
  };
  return types;
}

JointController::JointController(const JointControllerType & type, const ControllerSetup & setup)
: type_(type), car_(setup.car), commands_(setup.commands)
{
  for (const std::string & name : jointNames(type, setup)) {
    joints_.push_back(setup.joint(name, type.kind, type.is_group ? name + "/pid" : "pid"));
  }
  values_.resize(joints_.size());
  subscriber_ =
    type.is_group
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
  return {claimOf(type_.interface, names)};
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
