#pragma once

#include <workspace_support/parameter_reader.h>

#include <string>

#include "node/cars/command_input.h"
#include "node/cars/controllers/joint_command.h"
#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
/// What a controller is made from: its name and parameters, and the car that it belongs to.
struct ControllerSetup
{
  std::string name;
  std::string type;
  const CarHandle & car;    ///< its node in the namespace of the controller manager
  CommandInput & commands;  ///< is told of each command

  ros::NodeHandle node() const { return {car.node, name}; }
  workspace_support::ParameterReader parameters() const { return workspace_support::ParameterReader(node()); }

  /// The joint of the car that its parameter `joint` names. Gains of a PID controller, which are not simulated, cause
  /// a warning.
  /// @throws Error for one that the car does not have, or that cannot be moved in this way
  const JointDescription & joint(JointCommand::Kind kind) const;
};
}  // namespace f1tenth_sim2d
