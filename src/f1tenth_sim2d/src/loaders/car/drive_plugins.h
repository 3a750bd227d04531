#pragma once

#include "loaders/model/car_context.h"

namespace f1tenth_sim2d
{
/// Reads a plugin that drives the car, with the tags and defaults of gazebo_ros.
/// @throws LoadError
void readDrive(DriveDescription::Kind kind, const Element & plugin, CarContext & context);
}  // namespace f1tenth_sim2d
