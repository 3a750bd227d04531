#include "loaders/model/urdf_tree.h"

#include <set>

#include "loaders/frames/read_pose.h"

namespace f1tenth_sim2d
{
namespace
{
const std::set<std::string> kJointTypes{"revolute", "continuous", "prismatic", "fixed", "floating", "planar"};

/// Names of the joints for which <gazebo reference="JOINT"> says that its links stay apart.
std::set<std::string> preservedJoints(const Element & robot)
{
  std::set<std::string> names;
  for (const Element & extension : robot.children("gazebo")) {
    for (const char * const tag : {"preserveFixedJoint", "disableFixedJointLumping"}) {
      const std::string value = extension.child(tag).value();
      if (value == "true" || value == "True" || value == "yes" || value == "1") {
        names.insert(extension.attribute("reference"));
      }
    }
  }
  return names;
}

std::optional<Inertia> readInertia(const Element & link)
{
  const Element inertial = link.child("inertial");
  if (!inertial) {
    return std::nullopt;
  }
  const Element mass = inertial.child("mass");
  const Element m = inertial.child("inertia");
  if (!mass || !m) {
    inertial.fail(mass ? "has no <inertia>" : "has no <mass>");
  }
  const auto moment = [&m](const char * name) { return m.numberAttribute(name); };
  const Inertia about_itself{
    mass.numberAttribute("value"), Eigen::Vector3d::Zero(),
    symmetric(moment("ixx"), moment("iyy"), moment("izz"), moment("ixy"), moment("ixz"), moment("iyz"))};
  return placed(about_itself, readOrigin(inertial));
}

UrdfJoint readJoint(const Element & element, const std::set<std::string> & preserved)
{
  UrdfJoint joint{element, element.requiredAttribute("name"), element.requiredAttribute("type"), "", "", {}};
  if (kJointTypes.count(joint.type) == 0) {
    element.fail(
      "type is '" + joint.type + "', allowed are continuous, fixed, floating, planar, prismatic and revolute");
  }
  joint.parent = element.child("parent").attribute("link");
  joint.child = element.child("child").attribute("link");
  joint.origin = readOrigin(element);
  joint.is_joined = joint.type == "fixed" && preserved.count(joint.name) == 0;
  return joint;
}
}  // namespace

std::optional<Inertia> UrdfLink::joinedInertia() const
{
  std::optional<Inertia> sum = inertia;
  for (const UrdfLink * const child : children) {
    if (const auto more = child->isJoined() ? child->joinedInertia() : std::nullopt) {
      sum = sum ? *sum + *more : more;
    }
  }
  return sum;
}

UrdfTree::UrdfTree(const Element & robot)
{
  for (const Element & element : robot.children("link")) {
    const std::string name = element.requiredAttribute("name");
    if (!links_.try_emplace(name, UrdfLink{element, name}).second) {
      element.fail("this name is taken; names are unique among the links of a robot");
    }
  }
  const std::set<std::string> preserved = preservedJoints(robot);
  for (const Element & element : robot.children("joint")) {
    UrdfJoint joint = readJoint(element, preserved);
    const std::string name = joint.name;
    if (!joints_.try_emplace(name, std::move(joint)).second) {
      element.fail("this name is taken; names are unique among the joints of a robot");
    }
  }
  for (auto & [name, joint] : joints_) {
    connect(joint);
  }
  for (auto & [name, link] : links_) {
    if (!link.parent && root_) {
      robot.fail("has two links without a parent, '" + root_->name + "' and '" + name + "'; allowed is one");
    }
    root_ = link.parent ? root_ : &link;
  }
  if (!root_) {
    robot.fail(links_.empty() ? "has no <link>" : "has no link without a parent: its joints run in a ring");
  }
  std::size_t count = 0;
  place(*root_, {}, count);
  if (count < links_.size()) {
    robot.fail("has joints that run in a ring");
  }
}

void UrdfTree::connect(UrdfJoint & joint)
{
  for (const std::string & name : {joint.parent, joint.child}) {
    if (links_.count(name) == 0) {
      joint.element.fail("names the link '" + name + "', which is not there");
    }
  }
  UrdfLink & child = links_.at(joint.child);
  UrdfLink & parent = links_.at(joint.parent);
  if (child.parent) {
    joint.element.fail(
      "has the child '" + child.name + "', which is the child of the joint '" + child.joint->name + "' already");
  }
  child.joint = &joint;
  child.parent = &parent;
  parent.children.push_back(&child);
}

void UrdfTree::place(UrdfLink & link, const Pose3 & pose, std::size_t & count)
{
  ++count;
  link.pose = pose;
  if (link.inertia = readInertia(link.element); link.inertia) {
    link.inertia = placed(*link.inertia, pose);
  }
  for (UrdfLink * const child : link.children) {
    place(*child, pose * child->joint->origin, count);
  }
}
}  // namespace f1tenth_sim2d
