#pragma once

#include <ros/subscriber.h>

#include <string>
#include <vector>

#include "node/cars/controllers/controller.h"
#include "node/cars/controllers/controller_setup.h"

namespace f1tenth_sim2d
{
/// What a type of joint controller does to which joints.
struct JointControllerType
{
  std::string name;       ///< "velocity_controllers/JointVelocityController"
  std::string interface;  ///< "hardware_interface::VelocityJointInterface"
  JointCommand::Kind kind;
  bool is_group;  ///< several joints and a std_msgs/Float64MultiArray, or else one and a std_msgs/Float64
};

/// The types that there are.
const std::vector<JointControllerType> & jointControllerTypes();

/// A controller of one or several joints, with its topic `NAME/command`. A new one starts from standstill: 0.
class JointController : public Controller
{
public:
  /// @throws Error for joints that this type cannot move
  JointController(const JointControllerType & type, const ControllerSetup & setup);

  Claims claims() const override;
  void start(SimTime now) override;
  std::vector<JointCommand> update(SimTime now, double dt) override;

private:
  void take(const std::vector<double> & values);
  std::string objectionTo(const std::vector<double> & values) const;

  const JointControllerType & type_;
  const CarHandle car_;
  CommandInput & commands_;
  std::vector<ControlledJoint> joints_;
  std::vector<double> values_;  // of the joints
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_sim2d
