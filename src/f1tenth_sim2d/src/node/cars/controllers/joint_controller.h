#pragma once

#include <ros/subscriber.h>

#include <string>
#include <vector>

#include "node/cars/controllers/controller.h"
#include "node/cars/controllers/controller_setup.h"

namespace f1tenth_sim2d
{
/// A controller of one or several joints, with its topic `NAME/command`. A new one starts from standstill: 0.
class JointController : public Controller
{
public:
  /// @param interface  "hardware_interface::VelocityJointInterface"
  /// @param is_group   several joints and a std_msgs/Float64MultiArray, or else one and a std_msgs/Float64
  /// @throws Error for joints that this type cannot move
  JointController(const ControllerSetup & setup, const std::string & interface, JointCommand::Kind kind, bool is_group);

  Claims claims() const override;
  void start(SimTime now) override;
  std::vector<JointCommand> update(SimTime now, double dt) override;

private:
  void take(const std::vector<double> & values);
  std::string objectionTo(const std::vector<double> & values) const;

  const std::string interface_;
  const CarHandle car_;
  CommandInput & commands_;
  std::vector<ControlledJoint> joints_;
  std::vector<double> values_;  // of the joints
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_sim2d
