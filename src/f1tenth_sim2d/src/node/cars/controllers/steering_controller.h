#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/subscriber.h>

#include <vector>

#include "node/cars/controllers/controller.h"
#include "node/cars/controllers/controller_setup.h"
#include "node/cars/controllers/steering_odometry.h"
#include "node/cars/controllers/steering_parameters.h"
#include "node/world/schedule.h"

namespace f1tenth_sim2d
{
/// The AckermannSteeringController of ros_controllers: `NAME/cmd_vel` moves one rear wheel and one steering joint,
/// `NAME/odom` and a transform tell where the car went since the controller was started. As there, `angular.z` of a
/// command is the steering angle (rad), not a yaw rate.
class SteeringController : public Controller
{
public:
  /// @throws Error for joints that cannot be moved like this, std::runtime_error for parameters that make no sense
  explicit SteeringController(const ControllerSetup & setup);

  Claims claims() const override;
  void start(SimTime now) override;
  std::vector<JointCommand> update(SimTime now, double dt) override;

private:
  void take(const DriveCommand & command);
  void measure(double dt);
  DriveCommand allowed(const DriveCommand & wanted, double dt);
  void publish(SimTime now);

  const SteeringParameters p_;
  const CarHandle car_;
  CommandInput & commands_;
  ControlledJoint wheel_;
  ControlledJoint steering_;
  DriveCommand command_;
  SimTime command_time_{0};
  DriveCommand last_;           // allowed
  DriveCommand before_;         // the one before
  double wheel_position_{0.0};  // rad
  SteeringOdometry odometry_;
  Schedule schedule_;
  nav_msgs::Odometry message_;
  geometry_msgs::TransformStamped transform_;
  TopicPublisher<nav_msgs::Odometry> publisher_;
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_sim2d
