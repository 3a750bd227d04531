#pragma once

#include <optional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "node/cars/controllers/pid.h"

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

/// A joint in the hands of a controller. It is asked for a position (rad), a velocity (rad/s) or an effort (N m),
/// positive in the direction of its axis.
class ControlledJoint
{
public:
  /// @param wheel_radius  m
  ControlledJoint(const JointDescription & joint, JointCommand::Kind kind, double wheel_radius)
  : joint_(joint), kind_(kind), wheel_radius_(wheel_radius)
  {
  }

  const JointDescription & description() const { return joint_; }
  /// From now on the joint is moved by an effort-limited PID controller, as gazebo_ros_control moves it.
  void simulate(const PidGains & gains) { pid_.emplace(gains); }
  void restart();

  /// Why a value makes no sense; empty if it does.
  std::string objectionTo(double value) const;
  /// @param speed  of the joint now, rad/s
  /// @param dt     s since the call before
  /// @return valid as long as this object
  JointCommand command(double value, double speed, double dt);

private:
  JointDescription joint_;
  JointCommand::Kind kind_;
  double wheel_radius_;
  std::optional<Pid> pid_;
};
}  // namespace f1tenth_sim2d
