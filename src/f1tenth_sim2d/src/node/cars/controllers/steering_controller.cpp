#include "node/cars/controllers/steering_controller.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

#include "node/cars/joint_state.h"
#include "node/messages/conversions.h"

namespace f1tenth_sim2d
{
SteeringController::SteeringController(const ControllerSetup & setup)
: p_(readSteeringParameters(setup)),
  car_(setup.car),
  commands_(setup.commands),
  wheel_(setup.joint(p_.rear_wheel, JointCommand::Kind::kVelocity, p_.rear_wheel + "/pid")),
  steering_(setup.joint(p_.front_steer, JointCommand::Kind::kPosition, p_.front_steer + "/pid")),
  odometry_(static_cast<std::size_t>(p_.velocity_rolling_window_size)),
  publisher_(car_.advertise<nav_msgs::Odometry>(setup.name + "/odom"))
{
  message_.header.frame_id = transform_.header.frame_id = car_.frame(p_.odom_frame_id);
  message_.child_frame_id = transform_.child_frame_id = car_.frame(p_.base_frame_id);
  message_.pose.covariance = p_.pose_covariance;
  message_.twist.covariance = p_.twist_covariance;
  subscriber_ = setup.node().subscribe<geometry_msgs::Twist>(
    "cmd_vel", 1,
    [this](const geometry_msgs::Twist::ConstPtr & message) {
      take({message->linear.x, message->angular.z});
    },
    ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

Controller::Claims SteeringController::claims() const
{
  return {
    claimOf("hardware_interface::VelocityJointInterface", {wheel_.description().name}),
    claimOf("hardware_interface::PositionJointInterface", {steering_.description().name})};
}

void SteeringController::start(SimTime now)
{
  command_ = last_ = before_ = {};
  wheel_.restart();
  wheel_position_ = jointState(wheel_.description(), car_.simulation, car_.id).position;
  odometry_ = SteeringOdometry(static_cast<std::size_t>(p_.velocity_rolling_window_size));
  schedule_ = {};
  schedule_.add(
    periodOf(p_.publish_rate), [this](SimTime at) { publish(at); }, now);
}

std::vector<JointCommand> SteeringController::update(SimTime now, double dt)
{
  if (dt > 0.0) {
    measure(dt);
  }
  schedule_.run(now);
  const bool is_old = toSeconds(now - command_time_) > p_.cmd_vel_timeout;
  const DriveCommand next = allowed(is_old ? DriveCommand{} : command_, dt);
  before_ = last_;
  last_ = next;
  const double rolling = jointState(wheel_.description(), car_.simulation, car_.id).velocity;
  return {wheel_.command(next.speed / p_.wheel_radius, rolling, dt), steering_.command(next.steering_angle, 0.0, dt)};
}

DriveCommand SteeringController::allowed(const DriveCommand & wanted, double dt)
{
  return {
    limited(wanted.speed, last_.speed, before_.speed, dt, p_.linear),
    limited(wanted.steering_angle, last_.steering_angle, before_.steering_angle, dt, p_.angular)};
}

void SteeringController::take(const DriveCommand & command)
{
  std::string objection = wheel_.objectionTo(command.speed / p_.wheel_radius);
  if (objection.empty()) {
    objection = steering_.objectionTo(command.steering_angle);
  }
  if (objection.empty()) {
    command_ = command;
    command_time_ = car_.simulation.time();
  }
  commands_.noteTold(objection);
}

void SteeringController::measure(double dt)
{
  const double position = jointState(wheel_.description(), car_.simulation, car_.id).position;
  const double rolled = (position - wheel_position_) * p_.wheel_radius * p_.wheel_radius_multiplier;
  wheel_position_ = position;
  if (p_.open_loop) {
    // As in the original, which takes the angle for a yaw rate here.
    odometry_.advance(last_.speed * dt, last_.steering_angle * dt, dt);
    return;
  }
  const double angle = jointState(steering_.description(), car_.simulation, car_.id).position * p_.steer_pos_multiplier;
  const double wheelbase = p_.wheel_separation_h * p_.wheel_separation_h_multiplier;
  odometry_.advance(rolled, maths::tan(angle) * rolled / wheelbase, dt);
}

void SteeringController::publish(SimTime now)
{
  message_.header.stamp = transform_.header.stamp = toRosTime(now);
  message_.pose.pose = toPose(onGround(odometry_.pose()));
  message_.twist.twist = toTwist({odometry_.speed(), 0.0}, odometry_.yawRate());
  publisher_.publish(message_);
  if (p_.enable_odom_tf) {
    transform_.transform = toTransform(onGround(odometry_.pose()));
    car_.transforms.send(transform_);
  }
}
}  // namespace f1tenth_sim2d
