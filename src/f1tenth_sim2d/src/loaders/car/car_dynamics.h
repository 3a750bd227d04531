#pragma once

#include <vector>

#include "loaders/car/car_mechanism.h"

namespace f1tenth_sim2d
{
/// Works out the car's dynamics from masses, inertias, joints and friction of its description.
/// @throws LoadError for a pose that cannot be resolved
void readDynamics(const std::vector<MechanismJoint> & mechanism, CarContext & context);
}  // namespace f1tenth_sim2d
