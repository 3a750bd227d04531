#include "node/cars/controllers/joint_controller.h"

#include <std_msgs/Float64.h>

namespace f1tenth_sim2d
{
namespace
{
constexpr std::uint32_t kJointQueueSize = 10;
}  // namespace

JointController::JointController(const ControllerSetup & setup, const std::string & interface, JointCommand::Kind kind)
: interface_(interface),
  kind_(kind),
  joint_(setup.joint(kind)),
  wheel_radius_(setup.car.description().wheel_radius),
  commands_(setup.commands)
{
  subscriber_ = setup.node().subscribe<std_msgs::Float64>(
    "command", kJointQueueSize, [this](const std_msgs::Float64::ConstPtr & message) { take(message->data); },
    ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

Controller::Claim JointController::claim() const
{
  Claim claim;
  claim.hardware_interface = interface_;
  claim.resources = {joint_.name};
  return claim;
}

void JointController::take(double value)
{
  const std::string objection = objectionTo({kind_, joint_, value}, wheel_radius_);
  if (objection.empty()) {
    value_ = value;
  }
  commands_.noteTold(objection);
}
}  // namespace f1tenth_sim2d
