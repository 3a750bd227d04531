#include "node/cars/joint_controller.h"

#include <utility>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
const std::vector<JointControllerType> & jointControllerTypes()
{
  using Kind = JointCommand::Kind;
  static const std::vector<JointControllerType> types{
    {"velocity_controllers/JointVelocityController", "hardware_interface::VelocityJointInterface", Kind::kVelocity},
    {"velocity_controllers/JointPositionController", "hardware_interface::VelocityJointInterface", Kind::kPosition},
    {"position_controllers/JointPositionController", "hardware_interface::PositionJointInterface", Kind::kPosition},
    {"effort_controllers/JointEffortController", "hardware_interface::EffortJointInterface", Kind::kEffort},
    {"effort_controllers/JointVelocityController", "hardware_interface::EffortJointInterface", Kind::kVelocity},
    {"effort_controllers/JointPositionController", "hardware_interface::EffortJointInterface", Kind::kPosition},
  };
  return types;
}

JointController::JointController(
  const JointControllerType & type, const JointDescription & joint, double wheel_radius, ros::NodeHandle node,
  const std::string & name, Listener listener)
: type_(type), joint_(joint), wheel_radius_(wheel_radius), listener_(std::move(listener))
{
  if (joint.steers() != (type.kind == JointCommand::Kind::kPosition)) {
    throw Error(
      "controller " + name + ": " + type.name + " cannot move " + joint.name + ", which is a " +
      (joint.steers() ? "steering joint: take a JointPositionController"
                      : "wheel: take a JointVelocityController or a JointEffortController"));
  }
  subscriber_ = node.subscribe<std_msgs::Float64>(
    name + "/command", 10, [this](const std_msgs::Float64::ConstPtr & message) { take(message->data); },
    ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

void JointController::start()
{
  value_ = 0.0;
  if (pid_) {
    pid_->restart();
  }
}

JointCommand JointController::command(double speed, double dt)
{
  if (!pid_ || dt <= 0.0) {
    return {type_.kind, joint_, value_};
  }
  return {JointCommand::Kind::kEffort, joint_, pid_->effort(value_ - speed, dt, joint_.effort_max)};
}

void JointController::take(double value)
{
  const std::string objection = objectionTo({type_.kind, joint_, value}, wheel_radius_);
  if (objection.empty()) {
    value_ = value;
    listener_.accepted();
  } else {
    listener_.refused(objection);
  }
  listener_.heard();
}
}  // namespace f1tenth_sim2d
