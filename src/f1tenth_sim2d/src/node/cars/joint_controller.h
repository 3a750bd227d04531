#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Float64.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "node/cars/joint_command.h"

namespace f1tenth_sim2d
{
/// A type of joint controller: its name and what it does to which joints.
struct JointControllerType
{
  std::string name;  ///< "velocity_controllers/JointVelocityController"
  std::string interface;
  JointCommand::Kind kind;
};

/// The types that there are.
const std::vector<JointControllerType> & jointControllerTypes();

/// A controller of one joint, with its topic `NAME/command`. A new one starts from standstill: 0.
class JointController
{
public:
  using Refuse = std::function<void(const std::string & why)>;

  /// @param node    in the namespace of the controller manager
  /// @param refuse  told about each command that makes no sense; it is then not taken
  /// @throws Error for a joint that this type cannot move
  JointController(
    const JointControllerType & type, const JointDescription & joint, double wheel_radius, ros::NodeHandle node,
    const std::string & name, Refuse refuse);

  const JointControllerType & type() const { return type_; }
  const JointDescription & joint() const { return joint_; }
  void start() { value_ = 0.0; }
  JointCommand command() const { return {type_.kind, joint_, value_}; }

private:
  void take(double value);

  const JointControllerType & type_;
  const JointDescription joint_;
  const double wheel_radius_;
  const Refuse refuse_;
  double value_{0.0};
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_sim2d
