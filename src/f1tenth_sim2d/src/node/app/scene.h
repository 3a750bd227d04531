#pragma once

#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "node/cars/fleet.h"
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

/// Puts the cars of the parameters into it: reads their descriptions (/NAME/robot_description) and vehicle files.
/// @throws Error for what cannot be used
void addCars(const NodeParameters & parameters, const Pose2 & start, Fleet & fleet);

/// Says in one warning what of a source cannot be represented, if anything.
void warnOnce(const std::string & source, const std::vector<std::string> & warnings);
}  // namespace f1tenth_sim2d
