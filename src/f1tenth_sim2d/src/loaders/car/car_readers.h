#pragma once

#include <vector>

#include "loaders/car/car_mechanism.h"

namespace f1tenth_sim2d
{
/// Reads the plugins of the model. Those of gazebo_ros that are built in become parts of the car; the others are kept,
/// to be looked up as shared libraries.
/// @throws LoadError
void readPlugins(const std::vector<MechanismJoint> & mechanism, CarContext & context);

/// Reads a plugin that drives the car, with the tags and defaults of gazebo_ros.
/// @throws LoadError
void readDrive(DriveDescription::Kind kind, const Element & plugin, CarContext & context);

/// Works out the car's dynamics from masses, inertias, joints and friction of its description.
/// @throws LoadError for a pose that cannot be resolved
void readDynamics(const std::vector<MechanismJoint> & mechanism, CarContext & context);
}  // namespace f1tenth_sim2d
