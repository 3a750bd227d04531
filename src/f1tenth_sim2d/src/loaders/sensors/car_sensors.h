#pragma once

#include "loaders/model/car_context.h"

namespace f1tenth_sim2d
{
/// Fills in the car's lidars, bumpers and IMU from the sensors of its links. Needs the car's solids.
/// @throws LoadError
void readSensors(CarContext & context);
}  // namespace f1tenth_sim2d
