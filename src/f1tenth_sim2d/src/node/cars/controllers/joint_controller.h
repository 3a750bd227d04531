#pragma once

#include <ros/subscriber.h>

#include <string>

#include "node/cars/controllers/controller.h"
#include "node/cars/controllers/controller_setup.h"

namespace f1tenth_sim2d
{
/// A controller of one joint, with its topic `NAME/command` (std_msgs/Float64). A new one starts from standstill: 0.
class JointController : public Controller
{
public:
  /// @param interface  "hardware_interface::VelocityJointInterface"
  /// @throws Error for a joint that this type cannot move
  JointController(const ControllerSetup & setup, const std::string & interface, JointCommand::Kind kind);

  Claim claim() const override;
  void start(SimTime /*now*/) override { value_ = 0.0; }
  std::optional<JointCommand> command() const override { return JointCommand{kind_, joint_, value_}; }

private:
  void take(double value);

  const std::string interface_;
  const JointCommand::Kind kind_;
  const JointDescription joint_;
  const double wheel_radius_;  // m
  CommandInput & commands_;
  double value_{0.0};
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_sim2d
