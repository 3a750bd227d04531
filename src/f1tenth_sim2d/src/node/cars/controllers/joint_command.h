#pragma once

#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What a controller of ros_control asks of one joint.
struct JointCommand
{
  enum class Kind
  {
    kVelocity,  ///< rad/s, of a wheel
    kEffort,    ///< N m, of a wheel
    kPosition   ///< rad, of a steering joint
  } kind;
  const JointDescription & joint;
  double value;  ///< positive in the direction of the joint's axis
};

/// The command by which a driver of the car would move these joints in this way. Wheels roll at the mean of what is
/// asked of them; torques accelerate the car's mass. Steering joints are the two front wheels of Ackermann's geometry,
/// or the single-track one between them; the car steers by the mean of their single-track angles. What is not asked
/// for is 0.
/// @param speed  of the car now, m/s
DriveCommand driveCommand(
  const std::vector<JointCommand> & commands, const CarDescription & car, const VehicleParameters & vehicle,
  double speed);

/// Why a value makes no sense for a joint; empty if it does.
std::string objectionTo(const JointCommand & command, double wheel_radius);

}  // namespace f1tenth_sim2d
