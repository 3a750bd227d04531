#pragma once

#include "f1tenth_sim2d/simulation.h"
#include "node/parameters/node_parameters.h"

namespace f1tenth_sim2d
{
/// The simulation with its world, and what else the world says.
struct Scene
{
  Simulation simulation;
  double gravity;  ///< m/s^2, downwards
  Pose2 start;     ///< of cars that have no pose of their own
};

/// Reads the world and says once what of it cannot be represented. There are no cars in it yet.
/// @throws Error for what cannot be used
Scene buildScene(const NodeParameters & parameters);
}  // namespace f1tenth_sim2d
