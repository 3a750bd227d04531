#include "node/cars/controllers/controller_setup.h"

#include <ros/console.h>
#include <boost/algorithm/string/join.hpp>

#include <algorithm>
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
}  // namespace

ControlledJoint ControllerSetup::joint(
  const std::string & joint, JointCommand::Kind kind, const std::string & gains) const
{
  const CarDescription & description = car.description();
  ControlledJoint controlled(jointOf(description, joint, name), kind, description.wheel_radius);
  if (controlled.description().steers() != (kind == JointCommand::Kind::kPosition)) {
    throw Error(
      "controller " + name + ": " + type + " cannot move " + joint + ", which is a " +
      (controlled.description().steers() ? "steering joint: these take positions"
                                         : "wheel: these take velocities or efforts"));
  }
  auto found = gainsAt({node(), gains});
  if (!found) {
    found = gainsAt({car.node, "gazebo_ros_control/pid_gains/" + joint});
  }
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
