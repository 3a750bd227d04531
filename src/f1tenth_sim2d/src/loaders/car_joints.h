#pragma once

#include "car_context.h"

namespace f1tenth_sim2d
{
/// Finds the car's wheels and steering joints by type, axis and place, and from them wheel radius and track width.
/// Joints that a libgazebo_ros_joint_state_publisher.so names become the car's joints.
/// @param publishers  the plugins of that kind, may be none
/// @throws LoadError
void readJoints(const std::vector<sdf::ElementPtr> & publishers, CarContext & context);
}  // namespace f1tenth_sim2d
