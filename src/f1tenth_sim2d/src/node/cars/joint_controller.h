#pragma once

#include <ros/node_handle.h>
#include <std_msgs/Float64.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "node/cars/joint_command.h"
#include "node/cars/pid.h"

namespace f1tenth_sim2d
{
/// A type of joint controller: its name and what it does to which joints.
struct JointControllerType
{
  std::string name;  ///< "velocity_controllers/JointVelocityController"
  std::string interface;
  JointCommand::Kind kind;
};

/// The types that there are.
const std::vector<JointControllerType> & jointControllerTypes();

/// A controller of one joint, with its topic `NAME/command`. A new one starts from standstill: 0.
class JointController
{
public:
  struct Listener
  {
    std::function<void()> heard;                           ///< for each command
    std::function<void()> accepted;                        ///< for one that is taken
    std::function<void(const std::string & why)> refused;  ///< for one that makes no sense; it is not taken
  };

  /// @param node    in the namespace of the controller manager
  /// @throws Error for a joint that this type cannot move
  JointController(
    const JointControllerType & type, const JointDescription & joint, double wheel_radius, ros::NodeHandle node,
    const std::string & name, Listener listener);

  const JointControllerType & type() const { return type_; }
  const JointDescription & joint() const { return joint_; }
  void start();
  /// From now on the joint is moved by an effort-limited PID controller, as gazebo_ros_control moves it.
  void simulate(const PidGains & gains) { pid_.emplace(gains); }
  /// @param speed  of the joint now, rad/s, positive in the direction of its axis
  /// @param dt     s since the call before
  JointCommand command(double speed, double dt);

private:
  void take(double value);

  const JointControllerType & type_;
  const JointDescription joint_;
  const double wheel_radius_;
  const Listener listener_;
  double value_{0.0};
  std::optional<Pid> pid_;
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_sim2d
