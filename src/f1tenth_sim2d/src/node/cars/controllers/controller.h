#pragma once

#include <controller_manager_msgs/HardwareInterfaceResources.h>

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
  using Claims = std::vector<Claim>;

  virtual ~Controller() = default;
  /// Joints that nobody else may move while it runs, by hardware interface.
  virtual Claims claims() const = 0;
  /// It runs from now on; what came before is forgotten.
  virtual void start(SimTime now) = 0;
  /// To be called at each control period while it runs.
  /// @param dt  s since the call before; 0 if time was set back
  /// @return what it asks of its joints; valid until the next call
  virtual std::vector<JointCommand> update(SimTime now, double dt) = 0;

protected:
  static Claim claimOf(const std::string & interface, const std::vector<std::string> & joints)
  {
    Claim claim;
    claim.hardware_interface = interface;
    claim.resources = joints;
    return claim;
  }
};
}  // namespace f1tenth_sim2d
