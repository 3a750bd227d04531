#include "node/cars/controllers/controller_setup.h"

#include <ros/console.h>
#include <boost/algorithm/string/join.hpp>

#include <vector>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
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

void requireKind(const ControllerSetup & setup, const JointDescription & joint, JointCommand::Kind kind)
{
  if (joint.steers() != (kind == JointCommand::Kind::kPosition)) {
    throw Error(
      "controller " + setup.name + ": " + setup.type + " cannot move " + joint.name + ", which is a " +
      (joint.steers() ? "steering joint: these take positions" : "wheel: these take velocities or efforts"));
  }
}
}  // namespace

const JointDescription & ControllerSetup::joint(JointCommand::Kind kind) const
{
  std::string joint;
  parameters().readRequired("joint", joint);
  const JointDescription & description = jointOf(car.description(), joint, name);
  requireKind(*this, description, kind);
  if (node().hasParam("pid") || car.node.hasParam("gazebo_ros_control/pid_gains/" + joint)) {
    ROS_WARN(
      "controller %s: its pid gains are not simulated, %s follows as fast as the car can", name.c_str(), joint.c_str());
  }
  return description;
}
}  // namespace f1tenth_sim2d
