#include "loaders/sensors/sensor_readers.h"

#include <workspace_support/maths/trigonometry.h>
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

double stddevOf(const Element & noise)
{
  return isNoisy(noise) ? noise.notNegative("stddev", 0.0) : 0.0;
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

/// Noise of one quantity of an IMU; up to SDF 1.5 all axes had the same.
double imuNoise(const Element & imu, const char * quantity, const char * axis, const char * older)
{
  const Element noise = imu.child(quantity).child(axis).child("noise");
  return stddevOf(noise ? noise : imu.child("noise").child(older));
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

std::string topicOf(const Element & plugin, const char * tag, const char * by_default, CarContext & context)
{
  return context.topic(plugin, textOrDefault(plugin, tag, by_default, context));
}

std::string frameOf(const Element & plugin, CarContext & context)
{
  return frameId(plugin, textOrDefault(plugin, "frameName", "world", context));
}

/// The frame that an IMU plugin names, or else the link that carries it.
std::string imuFrame(const Element & plugin)
{
  return frameId(plugin, plugin.requiredText(plugin.child("frameName") ? "frameName" : "bodyName"));
}

/// Pose of the link that carries the IMU of a plugin, in the frame of the car.
Pose3 imuPose(const Element & plugin, const ImuDescription & imu, const CarContext & context)
{
  const auto link = context.car.link_poses.find(frameId(plugin, plugin.textOf("bodyName", imu.frame)));
  return link == context.car.link_poses.end() ? Pose3() : link->second;
}

/// Noise of one axis, from a tag with one number for all of them or with three.
double axisNoise(const Element & plugin, const char * tag, int axis)
{
  const std::string text = plugin.child(tag).text();
  const double noise = text.find_first_of(" \t\n") == std::string::npos
                         ? plugin.number(tag, 0.0)
                         : plugin.vector(tag, Eigen::Vector3d::Zero())[axis];
  plugin.requireNotNegative("<" + std::string(tag) + ">", noise);
  return noise;
}

void setImu(ImuDescription imu, const Element & element, CarContext & context)
{
  if (context.car.imu) {
    context.warnings.add("is a second IMU and left out", element.fileLine());
    return;
  }
  context.car.imu = std::move(imu);
}
/// Hz: the lower rate of sensor and plugin, if both are given.
double publishingRate(const SensorElement & element)
{
  const double of_plugin = element.plugin.rate("updateRate", 0.0);
  const double of_sensor = element.sensor.rate("update_rate", 0.0);
  return of_plugin > 0.0 && of_sensor > 0.0 ? std::min(of_plugin, of_sensor) : std::max(of_plugin, of_sensor);
}

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

void readSonar(const SensorElement & element, CarContext & context)
{
  const Element & plugin = element.plugin;
  const RayScan scan = readRayScan(element, "a sonar", context.warnings);
  const auto & place = scan.pose.position;
  SonarDescription sonar;
  sonar.name = element.sensor.name();
  sonar.topic = topicOf(plugin, "topicName", "/range", context);
  sonar.frame = frameOf(plugin, context);
  sonar.rate_hz = publishingRate(element);
  sonar.rays = {{place.x(), place.y(), scan.pose.yaw()}, place.z(), directions(scan), scan.range_max};
  sonar.range_min = scan.range_min;
  sonar.noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  sonar.field_of_view = plugin.notNegative("fov", sonar.field_of_view);
  sonar.is_infrared = plugin.textOf("radiation", "ultrasound") != "ultrasound";
  context.car.sonars.push_back(std::move(sonar));
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

void readImu(const SensorElement & element, CarContext & context)
{
  const Element & plugin = element.plugin;
  const Element noise = element.sensor.child("imu");
  ImuDescription imu;
  imu.name = element.sensor.name();
  imu.topic = topicOf(plugin, "topicName", "imu_data", context);
  imu.frame = imuFrame(plugin);
  imu.pose = element.pose;
  imu.rate_hz = plugin.rate("updateRateHZ", element.sensor.rate("update_rate", 0.0));
  const double of_plugin = plugin.notNegative("gaussianNoise", 0.0);
  imu.yaw_rate_noise_stddev = maths::hypot(of_plugin, imuNoise(noise, "angular_velocity", "z", "rate"));
  imu.acceleration_noise_stddev = maths::hypot(of_plugin, imuNoise(noise, "linear_acceleration", "x", "accel"));
  setImu(std::move(imu), element.sensor, context);
}

void readImuPlugin(const Element & plugin, CarContext & context)
{
  ImuDescription imu;
  imu.name = plugin.name();
  imu.topic = topicOf(plugin, "topicName", "/default_imu", context);
  imu.frame = imuFrame(plugin);
  imu.pose = imuPose(plugin, imu, context);
  imu.rate_hz = plugin.rate("updateRate", 0.0);
  imu.yaw_rate_noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  imu.acceleration_noise_stddev = imu.yaw_rate_noise_stddev;
  setImu(std::move(imu), plugin, context);
}

void readHectorImuPlugin(const Element & plugin, CarContext & context)
{
  ImuDescription imu;
  imu.name = plugin.name();
  imu.topic = context.topic(plugin, plugin.textOf("topicName", imu.topic));
  imu.frame = frameId(plugin, plugin.textOf("frameId", plugin.requiredText("bodyName")));
  imu.pose = imuPose(plugin, imu, context);
  imu.rate_hz = plugin.rate("updateRate", 0.0);
  imu.yaw_rate_noise_stddev = axisNoise(plugin, "rateGaussianNoise", 2);
  imu.acceleration_noise_stddev = axisNoise(plugin, "accelGaussianNoise", 0);
  setImu(std::move(imu), plugin, context);
}
}  // namespace f1tenth_sim2d
