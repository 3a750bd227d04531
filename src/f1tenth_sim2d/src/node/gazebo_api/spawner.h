#pragma once

#include <string>

#include "node/cars/fleet.h"

namespace f1tenth_sim2d
{
struct SpawnRequest
{
  std::string name;
  std::string xml;            ///< URDF or SDF
  std::string ros_namespace;  ///< of a car's topics
  Pose3 pose;                 ///< of the model's frame, in the world
};

/// Puts a car or a model into the running simulation: a description with turning joints, sensors or plugins becomes a car,
/// any other a model. A car whose place is not free comes to the nearest free one within a car's length, with a warning.
/// @throws Error
void spawnEntity(const SpawnRequest & request, Simulation & simulation, Fleet & fleet);
}  // namespace f1tenth_sim2d
