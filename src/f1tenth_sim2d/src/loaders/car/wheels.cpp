#include "loaders/car/wheels.h"

#include <algorithm>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

constexpr double kTurn = 6.28;               // rad; some descriptions give a wheel limits of a turn, rounded
constexpr double kAxleOnGround = 0.001;      // m, height up to which an axle is one at the ground
constexpr double kRadiusOfFlatWheel = 0.05;  // m, of a wheel without shape whose axle lies on the ground

/// Half the height of a mesh in the frame of the car.
double halfHeight(const TriangleMesh & mesh, const Pose3 & pose)
{
  Eigen::AlignedBox3d box;
  for (const Vector3d & vertex : mesh.vertices) {
    box.extend(pose * vertex);
  }
  return box.sizes().z() / 2.0;
}

double radiusOf(const Solid & solid)
{
  if (const auto * const cylinder = std::get_if<Cylinder>(&solid.shape)) {
    return cylinder->radius;
  }
  if (const auto * const sphere = std::get_if<Sphere>(&solid.shape)) {
    return sphere->radius;
  }
  if (const auto * const mesh = std::get_if<Mesh>(&solid.shape)) {
    return halfHeight(*mesh->surface, solid.pose);
  }
  return 0.0;
}

void measureWheel(MechanismJoint & wheel, const CarDescription & car)
{
  const std::string scope = car.name + "::" + wheel.child + "::";
  for (const Solid & solid : car.solids) {
    if (solid.name.rfind(scope, 0) == 0 && radiusOf(solid) > 0.0) {
      wheel.radius = radiusOf(solid);
      wheel.mu = solid.mu;
      return;
    }
  }
  wheel.radius = wheel.place.z() > kAxleOnGround ? wheel.place.z() : kRadiusOfFlatWheel;
}

bool turnsAllTheWay(const MechanismJoint & joint)
{
  return joint.description.upper - joint.description.lower >= kTurn;
}

/// Whether the radius is that of the shape of a wheel.
bool isMeasured(const MechanismJoint & joint)
{
  return !joint.steers() && joint.mu.has_value() && turnsAllTheWay(joint);
}

/// Where the measured wheels stand; without any, nothing is told of the others.
struct Stand
{
  double ground{std::numeric_limits<double>::infinity()};  ///< m
  double largest_radius{0.0};                              ///< m
};

Stand standOf(const std::vector<MechanismJoint> & joints)
{
  Stand stand;
  for (const MechanismJoint & joint : joints) {
    if (isMeasured(joint)) {
      stand.ground = std::min(stand.ground, joint.place.z() - joint.radius);
      stand.largest_radius = std::max(stand.largest_radius, joint.radius);
    }
  }
  return stand;
}

/// One radius of air below a wheel is allowed for: a caster, a suspension.
bool rolls(const MechanismJoint & joint, const Stand & stand)
{
  const double radius = isMeasured(joint) ? joint.radius : stand.largest_radius;
  return turnsAllTheWay(joint) && joint.place.z() <= stand.ground + 2.0 * radius;
}
}  // namespace

void measureWheels(std::vector<MechanismJoint> & joints, const CarDescription & car)
{
  for (MechanismJoint & joint : joints) {
    if (!joint.steers()) {
      measureWheel(joint, car);
    }
  }
}

void dropWhatDoesNotRoll(std::vector<MechanismJoint> & joints)
{
  const auto isNoWheel = [stand = standOf(joints)](const MechanismJoint & joint) {
    return !joint.steers() && !rolls(joint, stand);
  };
  joints.erase(std::remove_if(joints.begin(), joints.end(), isNoWheel), joints.end());
}
}  // namespace f1tenth_sim2d
