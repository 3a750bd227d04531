#include "car_joints.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sstream>

#include "element_reader.h"
#include "sdf_models.h"

namespace f1tenth_sim2d
{
namespace
{
using ignition::math::Vector3d;
using Role = JointDescription::Role;

/// A joint that turns, seen from base_footprint.
struct TurningJoint
{
  std::string name;
  std::string child;
  Vector3d place;  ///< m
  bool steers;     ///< axis upwards; otherwise it is a wheel's, to the side
};

bool isAlong(const Vector3d & axis, const Vector3d & direction)
{
  constexpr double kTiltAllowed = 0.1;  // rad: camber, caster and toe
  return std::abs(axis.Normalized().Dot(direction)) > std::cos(kTiltAllowed);
}

std::vector<TurningJoint> turningJoints(const CarContext & context)
{
  std::vector<TurningJoint> joints;
  for (std::uint64_t i = 0; i < context.model.JointCount(); ++i) {
    const sdf::Joint & joint = *context.model.JointByIndex(i);
    Vector3d axis;
    if (joint.Type() != sdf::JointType::REVOLUTE || !joint.Axis()->ResolveXyz(axis, "__model__").empty()) {
      continue;
    }
    axis = context.base_in_model.Rot().RotateVectorReverse(axis);
    const bool steers = isAlong(axis, Vector3d::UnitZ);
    if (steers || isAlong(axis, Vector3d::UnitY)) {
      const auto pose = resolvePose(joint.SemanticPose(), "__model__", joint.Element(), context.source());
      joints.push_back({joint.Name(), joint.ChildLinkName(), context.inBase(pose).Pos(), steers});
    }
  }
  return joints;
}

/// Where x changes from rear to front.
double middleOfWheels(const std::vector<TurningJoint> & joints)
{
  double rear = std::numeric_limits<double>::infinity();
  double front = -rear;
  for (const TurningJoint & joint : joints) {
    rear = std::min(rear, joint.place.X());
    front = std::max(front, joint.place.X());
  }
  return (rear + front) / 2.0;
}

Role roleOf(const TurningJoint & joint, double middle)
{
  const bool left = joint.place.Y() > 0.0;
  if (joint.steers) {
    return left ? Role::kSteeringLeft : Role::kSteeringRight;
  }
  if (joint.place.X() > middle) {
    return left ? Role::kWheelFrontLeft : Role::kWheelFrontRight;
  }
  return left ? Role::kWheelRearLeft : Role::kWheelRearRight;
}

/// Radius of the round collision element of a link, or else the height of its joint above the ground.
double wheelRadius(const TurningJoint & joint, const CarContext & context)
{
  const std::string scope = context.car.name + "::" + joint.child + "::";
  for (const Solid & solid : context.car.solids) {
    if (solid.name.rfind(scope, 0) == 0) {
      if (const auto * const cylinder = std::get_if<Cylinder>(&solid.shape)) {
        return cylinder->radius;
      }
      if (const auto * const sphere = std::get_if<Sphere>(&solid.shape)) {
        return sphere->radius;
      }
    }
  }
  return joint.place.Z();
}

void readDimensions(const std::vector<TurningJoint> & joints, CarContext & context)
{
  double left = 0.0;
  double right = 0.0;
  bool measured_at_steering = false;
  for (const TurningJoint & joint : joints) {
    if (!joint.steers) {
      context.car.wheel_radius = wheelRadius(joint, context);
    }
    if (joint.steers || !measured_at_steering) {
      (joint.place.Y() > 0.0 ? left : right) = joint.place.Y();
      measured_at_steering = measured_at_steering || joint.steers;
    }
  }
  if (left - right > 0.0) {
    context.car.track_width = left - right;
  }
}

std::vector<std::string> namesIn(std::string list)
{
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream text(list);
  return {std::istream_iterator<std::string>(text), {}};
}

void addJoint(
  const std::string & name, const std::vector<TurningJoint> & joints, const sdf::ElementPtr & publisher,
  CarContext & context)
{
  if (!context.model.JointNameExists(name)) {
    ElementReader(publisher, context.source()).fail("<jointName> names '" + name + "', which is no joint that moves");
  }
  const auto joint =
    std::find_if(joints.begin(), joints.end(), [&name](const TurningJoint & each) { return each.name == name; });
  if (joint == joints.end()) {
    context.warnings.add(
      "joint '" + name + "' is left out: neither a wheel nor a steering joint", elementPath(publisher));
    return;
  }
  const Role role = roleOf(*joint, middleOfWheels(joints));
  for (const JointDescription & other : context.car.joints) {
    if (other.name == name) {
      ElementReader(publisher, context.source()).fail("<jointName> names '" + name + "' twice");
    }
    if (other.role == role) {
      ElementReader(publisher, context.source())
        .fail("<jointName> names both '" + other.name + "' and '" + name + "' at the same corner of the car");
    }
  }
  context.car.joints.push_back({name, role});
}
}  // namespace

void readJoints(const std::vector<sdf::ElementPtr> & publishers, CarContext & context)
{
  const std::vector<TurningJoint> joints = turningJoints(context);
  readDimensions(joints, context);
  for (const sdf::ElementPtr & publisher : publishers) {
    const ElementReader reader(publisher, context.source());
    context.car.joint_state_rate_hz = reader.positive("updateRate");
    for (const std::string & name : namesIn(reader.requiredText("jointName"))) {
      addJoint(name, joints, publisher, context);
    }
  }
}
}  // namespace f1tenth_sim2d
