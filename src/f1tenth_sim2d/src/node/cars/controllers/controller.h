#pragma once

#include <controller_manager_msgs/HardwareInterfaceResources.h>

#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation_types.h"
#include "node/cars/controllers/joint_command.h"

namespace f1tenth_sim2d
{
/// A controller of ros_control, as its manager sees it.
class Controller
{
public:
  using Claim = controller_manager_msgs::HardwareInterfaceResources;

  virtual ~Controller() = default;
  /// The joint that nobody else may move while it runs, if it moves one, and its hardware interface.
  virtual Claim claim() const = 0;
  /// It runs from now on; what came before is forgotten.
  virtual void start(SimTime now) = 0;
  /// What it asks of its joint while it runs, if it moves one; valid as long as the controller.
  virtual std::optional<JointCommand> command() const { return std::nullopt; }
  /// To be called at each control period while it runs.
  virtual void publish(SimTime /*now*/) {}
};
}  // namespace f1tenth_sim2d
