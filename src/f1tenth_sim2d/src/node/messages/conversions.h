#pragma once

#include <gazebo_msgs/ContactState.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/simulation.h"

/// Between the core's types and messages.
namespace f1tenth_sim2d
{
geometry_msgs::Pose toPose(const Pose3 & pose);
geometry_msgs::Transform toTransformMessage(const Pose3 & pose);
/// A pose in the plane as one in space.
Pose3 onGround(const Pose2 & pose);
/// @param velocity  m/s, in the frame of the twist
geometry_msgs::Twist toTwist(const Vec2 & velocity, double yaw_rate);
/// What a Twist means to an Ackermann drive: its angular.z is a steering angle (rad), which changes sides in reverse.
DriveCommand toDriveCommand(const geometry_msgs::Twist & twist, const DriveDescription & drive);
/// The force is spread evenly over the contact points.
gazebo_msgs::ContactState toContactState(const Contact & contact);

/// A vector given in a frame turned by yaw, in the frame relative to which it is turned.
inline Vec2 rotated(const Vec2 & vector, double yaw)
{
  return transform({0.0, 0.0, yaw}, vector);
}
}  // namespace f1tenth_sim2d
