#pragma once

#include <string>

#include "node/cars/fleet.h"

namespace f1tenth_sim2d
{
/// Puts cars and models into the running simulation, from their descriptions.
class Spawner
{
public:
  Spawner(Simulation & simulation, Fleet & fleet) : simulation_(simulation), fleet_(fleet) {}

  struct Request
  {
    std::string name;
    std::string xml;            ///< URDF or SDF
    std::string ros_namespace;  ///< of a car's topics
    Pose3 pose;                 ///< of the model's frame, in the world
  };

  /// A description with turning joints, sensors or plugins becomes a car, any other a model. A car whose place is not
  /// free comes to the nearest free one within a car's length, with a warning.
  /// @throws Error
  void spawn(const Request & asked);

private:
  void spawnCar(const Request & request, const std::string & source);
  void addNear(const CarParameters & parameters, const CarDescription & car, const Pose2 & pose);
  void spawnModel(const Request & request, const std::string & source);

  Simulation & simulation_;
  Fleet & fleet_;
};
}  // namespace f1tenth_sim2d
