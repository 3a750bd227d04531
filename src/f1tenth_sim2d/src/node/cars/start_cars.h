#pragma once

#include <vector>

#include "node/cars/fleet.h"
#include "node/parameters/node_parameters.h"

namespace f1tenth_sim2d
{
/// Puts the cars of the parameters into the fleet: reads their descriptions (/NAME/robot_description) and vehicle files.
/// @param start  where the world says that cars without a pose of their own start
/// @throws Error for what cannot be used
void addCars(const std::vector<CarParameters> & cars, Pose2 start, Fleet & fleet);
}  // namespace f1tenth_sim2d
