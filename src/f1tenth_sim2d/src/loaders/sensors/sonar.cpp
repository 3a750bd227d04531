#include "core/components/sonar/sonar.h"

#include <algorithm>

#include "loaders/sensors/ray_scan.h"

namespace f1tenth_sim2d
{
namespace
{
/// rad, from the axis of the sonar, positive to the left.
std::vector<double> directions(const RayScan & scan)
{
  const double sense = scan.pose.up().z() < 0.0 ? -1.0 : 1.0;
  std::vector<double> angles{sense * scan.angle_min};
  for (int i = 1; i < scan.count; ++i) {
    angles.push_back(sense * (scan.angle_min + i * (scan.angle_max - scan.angle_min) / (scan.count - 1)));
  }
  return angles;
}
}  // namespace

void readSonar(const SensorElement & element, CarContext & context)
{
  const Element & plugin = element.plugin;
  const RayScan scan = readRayScan(element, "a sonar", context.warnings);
  const auto & place = scan.pose.position;
  Sonar::Options sonar;
  sonar.rays = {{place.x(), place.y(), scan.pose.yaw()}, place.z(), directions(scan), scan.range_max};
  sonar.range_min = scan.range_min;
  Mount mount = mountOf(element, "/range", context);
  mount.pose = scan.pose;
  mount.rate_hz = publishingRate(element);
  sonar.noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  sonar.field_of_view = plugin.notNegative("fov", sonar.field_of_view);
  sonar.is_infrared = plugin.textOf("radiation", "ultrasound") != "ultrasound";
  context.car.components.push_back(std::make_shared<Sonar>(std::move(mount), std::move(sonar)));
}
}  // namespace f1tenth_sim2d
