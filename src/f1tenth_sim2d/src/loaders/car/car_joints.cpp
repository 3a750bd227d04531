#include "loaders/car/car_joints.h"

#include <algorithm>

#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
std::vector<std::string> namesIn(std::string list)
{
  std::replace(list.begin(), list.end(), ',', ' ');
  return wordsIn(list);
}

void requireNewCorner(const JointDescription & joint, const Element & publisher, const CarDescription & car)
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
  const std::string & name, const std::vector<MechanismJoint> & mechanism, const Element & publisher,
  CarContext & context)
{
  const auto & joints = context.model.joints;
  if (std::none_of(joints.begin(), joints.end(), [&name](const JointPart & each) { return each.name == name; })) {
    publisher.fail("<jointName> names '" + name + "', which is no joint that moves");
  }
  const auto joint = std::find_if(
    mechanism.begin(), mechanism.end(), [&name](const MechanismJoint & each) { return each.description.name == name; });
  if (joint == mechanism.end()) {
    context.warnings.add(leftOut(name), publisher.fileLine());
    return;
  }
  requireNewCorner(joint->description, publisher, context.car);
  context.car.joints.push_back(joint->description);
}
}  // namespace

void readJointStatePublisher(
  const Element & publisher, const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  context.car.joint_state_rate_hz = publisher.rate("updateRate");
  context.car.joint_state_topic = context.topic(publisher, "joint_states");
  for (const std::string & name : namesIn(publisher.requiredText("jointName"))) {
    addJoint(name, mechanism, publisher, context);
  }
}
}  // namespace f1tenth_sim2d
