#pragma once

#include "loaders/sensors/sensor_readers.h"

namespace f1tenth_sim2d
{
/// Adds a sonar to the car.
/// @throws LoadError
void readSonar(const SensorElement & element, CarContext & context);
}  // namespace f1tenth_sim2d
