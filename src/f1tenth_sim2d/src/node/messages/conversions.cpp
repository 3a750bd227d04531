#include "node/messages/conversions.h"

#include <workspace_support/conversions.h>

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
geometry_msgs::Vector3 toVector3(const Vec2 & vector)
{
  geometry_msgs::Vector3 message;
  message.x = vector.x;
  message.y = vector.y;
  return message;
}

geometry_msgs::Wrench toWrench(const Vec2 & force, double torque, double share)
{
  geometry_msgs::Wrench message;
  message.force.x = force.x * share;
  message.force.y = force.y * share;
  message.torque.z = torque * share;
  return message;
}

/// A value that is not finite stays so, and is refused later.
double bounded(double value, double most)
{
  return std::isfinite(value) ? std::clamp(value, -most, most) : value;
}
}  // namespace

geometry_msgs::Pose toPose(const Pose3 & pose)
{
  return workspace_support::toPose(pose.position, pose.rotation);
}

geometry_msgs::Transform toTransformMessage(const Pose3 & pose)
{
  return workspace_support::toTransform(toPose(pose));
}

Pose3 onGround(const Pose2 & pose)
{
  return {pose.x, pose.y, 0.0, 0.0, 0.0, pose.yaw};
}

geometry_msgs::Twist toTwist(const Vec2 & velocity, double yaw_rate)
{
  geometry_msgs::Twist message;
  message.linear = toVector3(velocity);
  message.angular.z = yaw_rate;
  return message;
}

DriveCommand toDriveCommand(const geometry_msgs::Twist & twist, const DriveDescription & drive)
{
  const double angle = twist.angular.z * std::copysign(1.0, twist.linear.x);
  return {bounded(twist.linear.x, drive.speed_max), bounded(angle, drive.steering_max)};
}

gazebo_msgs::ContactState toContactState(const Contact & contact)
{
  gazebo_msgs::ContactState message;
  message.info = contact.own_collision + " touches " + contact.other_collision;
  message.collision1_name = contact.own_collision;
  message.collision2_name = contact.other_collision;
  message.total_wrench = toWrench(contact.force, contact.torque, 1.0);
  const double share = 1.0 / static_cast<double>(contact.positions.size());
  message.wrenches.assign(contact.positions.size(), toWrench(contact.force, contact.torque, share));
  for (const auto & position : contact.positions) {
    message.contact_positions.push_back(toVector3(position));
  }
  for (const auto & normal : contact.normals) {
    message.contact_normals.push_back(toVector3(normal));
  }
  message.depths = contact.depths;
  return message;
}
}  // namespace f1tenth_sim2d
