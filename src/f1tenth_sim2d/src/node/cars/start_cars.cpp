#include "node/cars/start_cars.h"

#include <ros/param.h>

#include <string>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "node/world/warnings.h"

namespace f1tenth_sim2d
{
namespace
{
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

void addCars(const std::vector<CarParameters> & cars, Pose2 start, Fleet & fleet)
{
  for (const auto & car : cars) {
    const CarDescription description = describe(car);
    warnOnce(description.source, description.warnings);
    const VehicleParameters vehicle =
      car.vehicle_file.empty() ? description.parameters : loadVehicleParameters(car.vehicle_file);
    fleet.add(car, description, vehicle, startPose(car, start));
  }
}
}  // namespace f1tenth_sim2d
