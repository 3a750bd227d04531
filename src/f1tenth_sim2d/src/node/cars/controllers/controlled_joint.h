#pragma once

#include <optional>
#include <string>

#include "node/cars/controllers/joint_command.h"
#include "node/cars/controllers/pid.h"

namespace f1tenth_sim2d
{
/// A joint in the hands of a controller. What is asked of it is a position (rad), a velocity (rad/s) or an effort (N m),
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
  /// @return valid as long as this
  JointCommand command(double value, double speed, double dt);

private:
  JointDescription joint_;
  JointCommand::Kind kind_;
  double wheel_radius_;
  std::optional<Pid> pid_;
};
}  // namespace f1tenth_sim2d
