#include "loaders/car/car_mechanism.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "loaders/car/wheels.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;
using Role = JointDescription::Role;

constexpr double kTiltAllowed = 0.1;       // rad: camber, caster and toe
constexpr double kPlaceTolerance = 0.001;  // m

bool isAlong(const Vector3d & axis, const Vector3d & direction)
{
  return std::abs(axis.normalized().dot(direction)) > maths::cos(kTiltAllowed);
}

bool turns(const JointPart & joint)
{
  return (joint.type == "revolute" || joint.type == "continuous") && joint.axis.norm() > 0.0 &&
         joint.lower < joint.upper;
}

JointDescription describe(const JointPart & joint, const Vector3d & axis, bool steers)
{
  JointDescription description{joint.name, steers ? Role::kSteeringLeft : Role::kWheelFrontLeft};
  description.direction = (steers ? axis.z() : axis.y()) > 0.0 ? 1.0 : -1.0;
  description.lower = joint.lower;
  description.upper = joint.upper;
  description.velocity_max = joint.velocity;
  description.effort_max = joint.effort;
  return description;
}

/// All joints that turn about the y or the z axis of the car.
std::vector<MechanismJoint> turningJoints(const CarContext & context)
{
  std::vector<MechanismJoint> joints;
  for (const JointPart & joint : context.model.joints) {
    if (!turns(joint)) {
      continue;
    }
    const Vector3d axis = context.car_in_model.rotation.conjugate() * joint.axis;
    const bool steers = isAlong(axis, Vector3d::UnitZ());
    if (steers || isAlong(axis, Vector3d::UnitY())) {
      joints.push_back({describe(joint, axis, steers), joint.child, context.inCar(joint.pose).position});
    }
  }
  return joints;
}

/// Whether a link hangs on another one, over any joints.
bool hangsOn(const Model & model, std::string link, const std::string & ancestor)
{
  for (std::size_t steps = 0; steps <= model.joints.size() && link != ancestor; ++steps) {
    std::string parent;
    for (const JointPart & joint : model.joints) {
      parent = joint.child == link ? joint.parent : parent;
    }
    link = parent;
  }
  return link == ancestor;
}

/// A joint about the z axis without a wheel on it turns something else: a camera, a spinning lidar.
void dropWhatDoesNotSteer(const Model & model, std::vector<MechanismJoint> & joints)
{
  const std::vector<MechanismJoint> all = joints;
  const auto steersNothing = [&](const MechanismJoint & joint) {
    return joint.steers() && std::none_of(all.begin(), all.end(), [&](const MechanismJoint & other) {
             return !other.steers() && hangsOn(model, other.child, joint.child);
           });
  };
  joints.erase(std::remove_if(joints.begin(), joints.end(), steersNothing), joints.end());
}

/// Where x changes from rear to front.
double middleOf(const std::vector<MechanismJoint> & joints)
{
  Eigen::AlignedBox3d box;
  for (const MechanismJoint & joint : joints) {
    box.extend(joint.place);
  }
  return box.center().x();
}

bool isInTheMiddle(const MechanismJoint & joint)
{
  return std::abs(joint.place.y()) < kPlaceTolerance;
}

/// @param middle  x where the car changes from rear to front
Role roleOf(const MechanismJoint & joint, double middle)
{
  const auto of = [&joint](Role left, Role right, Role in_the_middle) {
    return isInTheMiddle(joint) ? in_the_middle : joint.place.y() > 0.0 ? left : right;
  };
  if (joint.steers()) {
    return of(Role::kSteeringLeft, Role::kSteeringRight, Role::kSteeringMiddle);
  }
  if (joint.place.x() > middle) {
    return of(Role::kWheelFrontLeft, Role::kWheelFrontRight, Role::kWheelFrontMiddle);
  }
  return of(Role::kWheelRearLeft, Role::kWheelRearRight, Role::kWheelRearMiddle);
}

bool isRear(Role role)
{
  return role == Role::kWheelRearLeft || role == Role::kWheelRearRight || role == Role::kWheelRearMiddle;
}
}  // namespace

std::vector<MechanismJoint> findMechanism(const CarContext & context)
{
  std::vector<MechanismJoint> joints = turningJoints(context);
  measureWheels(joints, context.car);
  dropWhatDoesNotRoll(joints);
  dropWhatDoesNotSteer(context.model, joints);
  const double middle = middleOf(joints);
  for (MechanismJoint & joint : joints) {
    joint.description.role = roleOf(joint, middle);
  }
  return joints;
}

std::string leftOut(const std::string & joint)
{
  return "joint '" + joint +
         "' is left out: neither a wheel (about the y axis of the car, without limits, on the ground) nor a steering "
         "joint (about z, with a wheel on it)";
}

void warnOfOtherJoints(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  for (const JointPart & joint : context.model.joints) {
    const auto is_meant = [&joint](const MechanismJoint & each) { return each.description.name == joint.name; };
    // Some descriptions fix a joint by equal limits.
    const bool moves = joint.type != "fixed" && joint.lower != joint.upper;
    if (moves && std::none_of(mechanism.begin(), mechanism.end(), is_meant)) {
      context.warnings.add(leftOut(joint.name), joint.element.fileLine());
    }
  }
}

Pose3 properFrame(const std::vector<MechanismJoint> & mechanism)
{
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double ground = kInfinite;
  double left = -kInfinite;
  double right = kInfinite;
  double sum_of_x = 0.0;
  double count = 0.0;
  for (const MechanismJoint & joint : mechanism) {
    if (isRear(joint.description.role)) {
      left = std::max(left, joint.place.y());
      right = std::min(right, joint.place.y());
      sum_of_x += joint.place.x();
      count += 1.0;
    }
    if (!joint.steers()) {
      ground = std::min(ground, joint.place.z() - joint.radius);
    }
  }
  if (count == 0.0) {
    return Pose3();
  }
  const Vector3d place(sum_of_x / count, (left + right) / 2.0, ground);
  return place.cwiseAbs().maxCoeff() < kPlaceTolerance ? Pose3() : Pose3(place, Pose3::Rotation::Identity());
}

void readMechanism(const std::vector<MechanismJoint> & mechanism, CarDescription & car)
{
  std::map<Role, const MechanismJoint *> at_corner;
  double left = 0.0;
  double right = 0.0;
  bool measured_at_steering = false;
  for (const MechanismJoint & joint : mechanism) {
    const auto [known, is_first] = at_corner.try_emplace(joint.description.role, &joint);
    if (!is_first && joint.place.z() < known->second->place.z()) {
      known->second = &joint;
    }
    if (!joint.steers()) {
      car.wheel_radius = joint.radius;
    }
    if (!isInTheMiddle(joint) && (joint.steers() || !measured_at_steering)) {
      (joint.place.y() > 0.0 ? left : right) = joint.place.y();
      measured_at_steering = measured_at_steering || joint.steers();
    }
  }
  if (left - right > 0.0) {
    car.track_width = left - right;
  }
  for (const auto & [role, joint] : at_corner) {
    car.mechanism.push_back(joint->description);
  }
}
}  // namespace f1tenth_sim2d
