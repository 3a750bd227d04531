#include "core/components/imu/imu.h"

#include <workspace_support/maths/trigonometry.h>

#include <algorithm>

#include "loaders/sensors/sensor_readers.h"

namespace f1tenth_sim2d
{
namespace
{
/// Noise of one quantity of an IMU; up to SDF 1.5 all axes had the same.
double imuNoise(const Element & imu, const char * quantity, const char * axis, const char * older)
{
  const Element noise = imu.child(quantity).child(axis).child("noise");
  return stddevOf(noise ? noise : imu.child("noise").child(older));
}

/// The frame that an IMU plugin names, or else the link that carries it.
std::string imuFrame(const Element & plugin)
{
  return frameId(plugin, plugin.requiredText(plugin.child("frameName") ? "frameName" : "bodyName"));
}

/// Pose of the link that carries the IMU of a plugin, in the frame of the car.
Pose3 imuPose(const Element & plugin, const std::string & frame, const CarContext & context)
{
  const auto link = context.car.link_poses.find(frameId(plugin, plugin.textOf("bodyName", frame)));
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

void addImu(Mount mount, const Imu::Noise & noise, const Element & element, CarContext & context)
{
  const auto & all = context.car.components;
  const auto is_imu = [](const auto & component) { return dynamic_cast<const Imu *>(component.get()) != nullptr; };
  if (std::any_of(all.begin(), all.end(), is_imu)) {
    context.warnings.add("is a second IMU and left out", element.fileLine());
    return;
  }
  context.car.components.push_back(std::make_shared<Imu>(std::move(mount), noise));
}
}  // namespace

void readImu(const SensorElement & element, CarContext & context)
{
  const Element & plugin = element.plugin;
  const Element noise = element.sensor.child("imu");
  Mount mount;
  mount.name = element.sensor.name();
  mount.topic = topicOf(plugin, "topicName", "imu_data", context);
  mount.frame = imuFrame(plugin);
  mount.pose = element.pose;
  mount.rate_hz = plugin.rate("updateRateHZ", element.sensor.rate("update_rate", 0.0));
  const double of_plugin = plugin.notNegative("gaussianNoise", 0.0);
  addImu(
    std::move(mount),
    {maths::hypot(of_plugin, imuNoise(noise, "angular_velocity", "z", "rate")),
     maths::hypot(of_plugin, imuNoise(noise, "linear_acceleration", "x", "accel"))},
    element.sensor, context);
}

void readImuPlugin(const Element & plugin, CarContext & context)
{
  Mount mount;
  mount.name = plugin.name();
  mount.topic = topicOf(plugin, "topicName", "/default_imu", context);
  mount.frame = imuFrame(plugin);
  mount.pose = imuPose(plugin, mount.frame, context);
  mount.rate_hz = plugin.rate("updateRate", 0.0);
  const double noise = plugin.notNegative("gaussianNoise", 0.0);
  addImu(std::move(mount), {noise, noise}, plugin, context);
}

void readHectorImuPlugin(const Element & plugin, CarContext & context)
{
  Mount mount;
  mount.name = plugin.name();
  mount.topic = context.topic(plugin, plugin.textOf("topicName", "imu"));
  mount.frame = frameId(plugin, plugin.textOf("frameId", plugin.requiredText("bodyName")));
  mount.pose = imuPose(plugin, mount.frame, context);
  mount.rate_hz = plugin.rate("updateRate", 0.0);
  addImu(
    std::move(mount), {axisNoise(plugin, "rateGaussianNoise", 2), axisNoise(plugin, "accelGaussianNoise", 0)}, plugin,
    context);
}
}  // namespace f1tenth_sim2d
