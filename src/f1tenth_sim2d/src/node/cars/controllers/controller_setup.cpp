#include "node/cars/controllers/controller_setup.h"

#include <ros/console.h>
#include <boost/algorithm/string/join.hpp>

#include <optional>
#include <vector>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
using workspace_support::ParameterReader;

std::optional<PidGains> gainsAt(const ros::NodeHandle & node)
{
  PidGains gains;
  ParameterReader reader(node);
  reader.read("i_clamp", gains.i_clamp, workspace_support::atLeast(0.0));
  const bool has_p = reader.read("p", gains.p);
  const bool has_i = reader.read("i", gains.i);
  const bool has_d = reader.read("d", gains.d);
  return has_p || has_i || has_d ? std::optional(gains) : std::nullopt;
}

const JointDescription & jointOf(const CarDescription & car, const std::string & name, const std::string & controller)
{
  std::vector<std::string> names;
  for (const JointDescription & joint : car.mechanism) {
    if (joint.name == name) {
      return joint;
    }
    names.push_back(joint.name);
  }
  throw Error(
    "controller " + controller + ": no joint " + name + " that moves; there are " +
    boost::algorithm::join(names, ", "));
}

/// The gains at a place below the parameters of the controller, or else those of gazebo_ros_control.
std::optional<PidGains> gainsOf(const ControllerSetup & setup, const std::string & place, const std::string & joint)
{
  const auto own = gainsAt({setup.node(), place});
  return own ? own : gainsAt({setup.car.node, "gazebo_ros_control/pid_gains/" + joint});
}

void requireKind(const ControllerSetup & setup, const JointDescription & joint, JointCommand::Kind kind)
{
  if (joint.steers() != (kind == JointCommand::Kind::kPosition)) {
    throw Error(
      "controller " + setup.name + ": " + setup.type + " cannot move " + joint.name + ", which is a " +
      (joint.steers() ? "steering joint: these take positions" : "wheel: these take velocities or efforts"));
  }
}
}  // namespace

ControlledJoint ControllerSetup::joint(
  const std::string & joint, JointCommand::Kind kind, const std::string & gains) const
{
  const JointDescription & description = jointOf(car.description(), joint, name);
  requireKind(*this, description, kind);
  ControlledJoint controlled(description, kind, car.description().wheel_radius);
  const auto found = gainsOf(*this, gains, joint);
  if (found && simulates_pid && kind == JointCommand::Kind::kVelocity) {
    controlled.simulate(*found);
  } else if (found) {
    ROS_WARN(
      "controller %s: its pid gains are not simulated, %s follows as fast as the car can%s", name.c_str(),
      joint.c_str(), simulates_pid ? "" : " (the simulator's parameter simulate_pid: true does)");
  }
  return controlled;
}
}  // namespace f1tenth_sim2d
