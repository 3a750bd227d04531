#pragma once

#include "f1tenth_sim2d/simulation.h"
#include "node_parameters.h"

namespace f1tenth_sim2d
{
/// The simulation with its world and all cars, and what else the world says.
struct Scene
{
  Simulation simulation;
  double gravity;  ///< m/s^2, downwards
};

/// Reads the world, and the description and vehicle file of each car (/NAME/robot_description), and says once what of
/// them cannot be represented.
/// @throws Error for what cannot be used
Scene buildScene(const NodeParameters & parameters);
}  // namespace f1tenth_sim2d
