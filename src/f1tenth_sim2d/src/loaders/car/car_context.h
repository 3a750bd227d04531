#pragma once

#include <sdf/Model.hh>
#include <string>

#include "f1tenth_sim2d/car_model.h"
#include "loaders/car/robot_text.h"
#include "loaders/files/warning_collector.h"
#include "loaders/sdf/element_reader.h"

namespace f1tenth_sim2d
{
/// What the readers of a car's parts share while it is being read.
struct CarContext
{
  const sdf::Model & model;
  const RobotFacts & facts;
  Pose3 car_in_model;  ///< pose of the car's frame in the frame of the model
  CarDescription & car;
  WarningCollector & warnings;

  const std::string & source() const { return car.source; }

  Pose3 inCar(const Pose3 & in_model) const { return car_in_model.inverse() * in_model; }

  /// A frame id without slash in front and without the car's name: the node puts the prefix before it.
  std::string withoutPrefix(std::string frame) const;

  /// What <robotNamespace> of a plugin means: "/other", "/", or nothing if it is the car's own.
  std::string rosNamespace(const sdf::ElementPtr & plugin) const;

  /// A topic of a plugin, its <robotNamespace> put before it unless that is the car's own.
  std::string topic(const sdf::ElementPtr & plugin, const std::string & name) const;

  /// Text of a tag of a plugin as the URDF has it: libsdformat replaces links that fixed joints have joined with others.
  std::string originalText(const sdf::ElementPtr & plugin, const std::string & tag, const std::string & fallback) const;
};

/// Name of a shared library without folder: Gazebo accepts both.
std::string libraryName(const sdf::ElementPtr & plugin);
}  // namespace f1tenth_sim2d
