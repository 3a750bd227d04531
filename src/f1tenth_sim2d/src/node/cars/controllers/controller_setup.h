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
  bool simulates_pid;       ///< whether wheels obey their pid gains, or else follow as fast as the car can

  ros::NodeHandle node() const { return {car.node, name}; }
  workspace_support::ParameterReader parameters() const { return workspace_support::ParameterReader(node()); }

  /// A joint of the car in the hands of this controller.
  /// @param gains  where its pid gains are below the parameters of the controller; if there are none, those of
  ///               gazebo_ros_control count. Gains that are not simulated cause a warning
  /// @throws Error for one that the car does not have, or that cannot be moved in this way
  ControlledJoint joint(const std::string & joint, JointCommand::Kind kind, const std::string & gains) const;
};
}  // namespace f1tenth_sim2d
