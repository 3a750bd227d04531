#pragma once

#include <ignition/math/Pose3.hh>
#include <sdf/Model.hh>
#include <string>

#include "f1tenth_sim2d/car_model.h"
#include "warning_collector.h"

namespace f1tenth_sim2d
{
/// What the readers of a car's parts share while it is being read.
struct CarContext
{
  const sdf::Model & model;
  ignition::math::Pose3d base_in_model;  ///< pose of base_footprint in the frame of the model
  CarDescription & car;
  WarningCollector & warnings;

  const std::string & source() const { return car.source; }

  ignition::math::Pose3d inBase(const ignition::math::Pose3d & in_model) const
  {
    return base_in_model.Inverse() * in_model;
  }

  /// A frame id without slash in front and without the car's name: the node puts the prefix before it.
  std::string withoutPrefix(std::string frame) const
  {
    for (const std::string & prefix : {std::string("/"), car.name + "/"}) {
      if (frame.rfind(prefix, 0) == 0) {
        frame.erase(0, prefix.size());
      }
    }
    return frame;
  }
};

/// Name of a shared library without folder: Gazebo accepts both.
inline std::string libraryName(const sdf::ElementPtr & plugin)
{
  const auto filename = plugin->Get<std::string>("filename");
  return filename.substr(filename.find_last_of('/') + 1);
}
}  // namespace f1tenth_sim2d
