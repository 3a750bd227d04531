#pragma once

#include "node/cars/sensor_output.h"

namespace f1tenth_sim2d
{
/// One output for each of the car's `sensors`.
OutputList sensorOutputs(const CarHandle & car);
}  // namespace f1tenth_sim2d
