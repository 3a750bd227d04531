#pragma once

#include <vector>

#include "loaders/car/car_mechanism.h"

namespace f1tenth_sim2d
{
/// Joints that a libgazebo_ros_joint_state_publisher.so names become those that joint_states carries.
/// @throws LoadError
void readJointStatePublisher(
  const Element & publisher, const std::vector<MechanismJoint> & mechanism, CarContext & context);
}  // namespace f1tenth_sim2d
