#include "loaders/sensors/sensor_readers.h"

#include <algorithm>
#include <cmath>

#include "f1tenth_sim2d/errors.h"
#include "loaders/sensors/ray_scan.h"

namespace f1tenth_sim2d
{
namespace
{
/// Whether there is noise; a <noise> has its type as an attribute or as an element.
bool isNoisy(const Element & noise)
{
  return noise && noise.attribute("type") != "none" && noise.child("type").text() != "none";
}

/// Bias of a lidar, m.
double biasOf(const RayScan & scan, const Element & sensor)
{
  const double bias = isNoisy(scan.ray.child("noise")) ? scan.ray.number("noise/mean", 0.0) : 0.0;
  if (!(std::abs(bias) <= scan.range_max)) {
    sensor.fail(
      "<noise/mean> is " + toText(bias) + ", allowed are numbers from " + toText(-scan.range_max) + " to " +
      toText(scan.range_max) + ", the greatest range (m)");
  }
  return bias;
}

/// What gazebo_ros takes where a plugin does not say it; rarely what was meant, so it is said.
std::string textOrDefault(const Element & plugin, const char * tag, const char * by_default, CarContext & context)
{
  if (!plugin.child(tag)) {
    context.warnings.add(
      "has no <" + std::string(tag) + ">: taken as '" + by_default + "', as in gazebo_ros", plugin.fileLine());
    return by_default;
  }
  return plugin.requiredText(tag);
}
}  // namespace

double publishingRate(const SensorElement & element)
{
  const double of_plugin = element.plugin.rate("updateRate", 0.0);
  const double of_sensor = element.sensor.rate("update_rate", 0.0);
  return of_plugin > 0.0 && of_sensor > 0.0 ? std::min(of_plugin, of_sensor) : std::max(of_plugin, of_sensor);
}

double stddevOf(const Element & noise)
{
  return isNoisy(noise) ? noise.notNegative("stddev", 0.0) : 0.0;
}

std::string topicOf(const Element & plugin, const char * tag, const char * by_default, CarContext & context)
{
  return context.topic(plugin, textOrDefault(plugin, tag, by_default, context));
}

std::string frameOf(const Element & plugin, CarContext & context)
{
  return frameId(plugin, textOrDefault(plugin, "frameName", "world", context));
}

Mount mountOf(const SensorElement & element, const char * topic, CarContext & context)
{
  Mount mount;
  mount.name = element.sensor.name();
  mount.topic = topicOf(element.plugin, "topicName", topic, context);
  mount.frame = frameOf(element.plugin, context);
  mount.pose = element.pose;
  mount.rate_hz = element.sensor.rate("update_rate", 0.0);
  return mount;
}

void readLidar(const SensorElement & element, CarContext & context)
{
  const Element & sensor = element.sensor;
  const RayScan scan = readRayScan(element, "a lidar", context.warnings);
  LidarDescription lidar;
  lidar.name = sensor.name();
  lidar.topic = topicOf(element.plugin, "topicName", "/world", context);
  lidar.frame = frameOf(element.plugin, context);
  lidar.pose = scan.pose;
  lidar.rate_hz = sensor.rate("update_rate", 0.0);
  lidar.beam_count = scan.count;
  lidar.angle_min = scan.angle_min;
  lidar.angle_max = scan.angle_max;
  lidar.range_min = scan.range_min;
  lidar.range_max = scan.range_max;
  lidar.noise_mean = biasOf(scan, sensor);
  lidar.noise_stddev = stddevOf(scan.ray.child("noise"));
  context.car.lidars.push_back(std::move(lidar));
}

void readBumper(const SensorElement & element, CarContext & context)
{
  BumperDescription bumper;
  bumper.name = element.sensor.name();
  bumper.topic = topicOf(element.plugin, "bumperTopicName", "bumper_states", context);
  bumper.frame = frameOf(element.plugin, context);
  bumper.rate_hz = element.sensor.rate("update_rate", 0.0);
  bumper.collision_names = collisionsOfContactSensor(element.sensor, element.link, context);
  context.car.bumpers.push_back(std::move(bumper));
}
}  // namespace f1tenth_sim2d
