#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loaders/model/car_context.h"

namespace f1tenth_sim2d
{
/// A wheel or a steering joint, with its place in the frame of the car.
struct MechanismJoint
{
  JointDescription description;
  std::string child;           ///< link
  Eigen::Vector3d place;       ///< m
  double radius{0.0};          ///< m, of a wheel
  std::optional<double> mu{};  ///< friction coefficient of a wheel with a round collision

  bool steers() const { return description.steers(); }
};

/// Finds the car's wheels and steering joints. Wheels turn about the y axis, all the way round, and reach the ground;
/// steering joints turn about the z axis and carry a wheel; their position tells front, rear, left and right. Needs the
/// car's solids.
/// @throws LoadError for an axis that cannot be resolved
std::vector<MechanismJoint> findMechanism(const CarContext & context);

/// Warns of joints that could move, but are none of these.
void warnOfOtherJoints(const std::vector<MechanismJoint> & mechanism, CarContext & context);

/// The text of a warning about such a joint.
std::string leftOut(const std::string & joint);

/// Where the car's frame belongs, seen from where it is: on the ground below the middle of the rear axle. A frame that
/// is there to within a millimetre stays, as does that of a car without wheels.
Pose3 properFrame(const std::vector<MechanismJoint> & mechanism);

/// Fills in the car's mechanism, wheel radius and track width: of joints at the same corner the lowest counts.
void readMechanism(const std::vector<MechanismJoint> & mechanism, CarDescription & car);
}  // namespace f1tenth_sim2d
