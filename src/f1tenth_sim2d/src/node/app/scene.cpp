#include "node/app/scene.h"

#include <malloc.h>
#include <ros/console.h>
#include <ros/param.h>

#include <string>
#include <utility>
#include <vector>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"

namespace f1tenth_sim2d
{
namespace
{
std::vector<std::string> worldWarnings(const WorldDescription & world)
{
  std::vector<std::string> warnings = world.warnings;
  for (const auto & plugin : world.plugins) {
    warnings.push_back(plugin.place + ": plugin " + plugin.filename + " of the world");
  }
  return warnings;
}

CarDescription describe(const CarParameters & car)
{
  const std::string parameter = "/" + car.name + "/robot_description";
  std::string xml;
  if (!ros::param::get(parameter, xml)) {
    throw Error("parameter " + parameter + ": not set, expected the URDF or SDF text of the car");
  }
  return loadCar(xml, car.name, parameter, searchPathFromEnvironment());
}
}  // namespace

void warnOnce(const std::string & source, const std::vector<std::string> & warnings)
{
  if (warnings.empty()) {
    return;
  }
  std::string text;
  for (const auto & warning : warnings) {
    text += "\n  " + warning;
  }
  ROS_WARN("%s: not represented:%s", source.c_str(), text.c_str());
}

Scene buildScene(const NodeParameters & parameters)
{
  const WorldDescription world = loadWorld(parameters.world_file, searchPathFromEnvironment());
  warnOnce(world.file, worldWarnings(world));
  return {Simulation(world, parameters.simulation), world.gravity, world.start};
}

void addCars(const NodeParameters & parameters, const Pose2 & start, Fleet & fleet)
{
  for (const auto & car : parameters.cars) {
    const CarDescription description = describe(car);
    warnOnce(description.source, description.warnings);
    const VehicleParameters vehicle =
      car.vehicle_file.empty() ? description.parameters : loadVehicleParameters(car.vehicle_file);
    fleet.add(car, description, vehicle, startPose(car, start));
  }
  // libsdformat has used some 100 MB by now, which the C library would keep.
  malloc_trim(0);
}
}  // namespace f1tenth_sim2d
