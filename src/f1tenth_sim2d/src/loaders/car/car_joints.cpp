#include "loaders/car/car_joints.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace f1tenth_sim2d
{
namespace
{
std::vector<std::string> namesIn(std::string list)
{
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream text(list);
  return {std::istream_iterator<std::string>(text), {}};
}

void requireNewCorner(const JointDescription & joint, const ElementReader & publisher, const CarDescription & car)
{
  for (const JointDescription & other : car.joints) {
    if (other.name == joint.name) {
      publisher.fail("<jointName> names '" + joint.name + "' twice");
    }
    if (other.role == joint.role) {
      publisher.fail(
        "<jointName> names both '" + other.name + "' and '" + joint.name + "' at the same corner of the car");
    }
  }
}

void addJoint(
  const std::string & name, const std::vector<MechanismJoint> & mechanism, const sdf::ElementPtr & publisher,
  CarContext & context)
{
  const ElementReader reader(publisher, context.source());
  if (!context.model.JointNameExists(name)) {
    reader.fail("<jointName> names '" + name + "', which is no joint that moves");
  }
  const auto joint = std::find_if(
    mechanism.begin(), mechanism.end(), [&name](const MechanismJoint & each) { return each.description.name == name; });
  if (joint == mechanism.end()) {
    context.warnings.add(
      "joint '" + name + "' is left out: neither a wheel nor a steering joint", elementPath(publisher));
    return;
  }
  requireNewCorner(joint->description, reader, context.car);
  context.car.joints.push_back(joint->description);
}
}  // namespace

void readJointStatePublisher(
  const sdf::ElementPtr & publisher, const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  const ElementReader reader(publisher, context.source());
  context.car.joint_state_rate_hz = reader.positive("updateRate");
  context.car.joint_state_topic = context.topic(publisher, "joint_states");
  for (const std::string & name : namesIn(reader.requiredText("jointName"))) {
    addJoint(name, mechanism, publisher, context);
  }
}
}  // namespace f1tenth_sim2d
