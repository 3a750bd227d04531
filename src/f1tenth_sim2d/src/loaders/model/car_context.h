#pragma once

#include <string>

#include "f1tenth_sim2d/car_model.h"
#include "loaders/model/model.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// What the readers of a car's parts share while it is being read.
struct CarContext
{
  const Model & model;
  Pose3 car_in_model;  ///< pose of the car's frame in the frame of the model
  CarDescription & car;
  WarningCollector & warnings;

  Pose3 inCar(const Pose3 & in_model) const { return car_in_model.inverse() * in_model; }

  /// What <robotNamespace> of a plugin means: "/other", "/", or nothing if it is the car's own.
  std::string rosNamespace(const Element & plugin) const;

  /// A topic of a plugin, with its <robotNamespace> in front unless that is the car's own.
  /// @throws LoadError for what roscpp does not accept as a name
  std::string topic(const Element & plugin, const std::string & given) const;
};

/// A frame id without leading slash.
/// @throws LoadError for an invalid one
std::string frameId(const Element & place, const std::string & given);

/// @throws LoadError unless roscpp accepts the name: letters, digits, _ and /, beginning with a letter or /
void requireRosName(const Element & place, const std::string & what, const std::string & name);

/// Name of a shared library without folder: Gazebo accepts both.
std::string libraryName(const Element & plugin);
}  // namespace f1tenth_sim2d
