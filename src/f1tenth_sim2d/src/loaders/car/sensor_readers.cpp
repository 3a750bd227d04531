#include "loaders/car/sensor_readers.h"

#include <cmath>
#include <sstream>

#include "loaders/car/contact_sensor.h"

namespace f1tenth_sim2d
{
namespace
{
/// rad; more than angles rounded to three digits, less than anyone tilts a lidar on purpose.
constexpr double kLevelTolerance = 1e-3;
constexpr double kBeamAngleMax = 12.56637;  // rad, two turns: beams beyond one look where others look
constexpr int kBeamCountMax = 100'000;

void requireLevel(const SensorElement & element)
{
  const Eigen::Vector3d up = element.pose.up();
  if (up.z() < 0.0 || std::hypot(up.x(), up.y()) > kLevelTolerance) {
    element.sensor.fail("is tilted; a lidar has to be level, with its z axis upwards");
  }
}

/// Beams of a scan line; those between the samples count.
int beamCount(const Element & sensor, const Element & horizontal)
{
  const double count = horizontal.number("samples", 640.0) * horizontal.number("resolution", 1.0);
  if (!(count >= 2.0 && count <= kBeamCountMax)) {
    std::ostringstream message;
    message << "has " << count << " <samples>, allowed are 2 to " << kBeamCountMax;
    sensor.fail(message.str());
  }
  return static_cast<int>(std::lround(count));
}

void requireSound(const LidarDescription & lidar, const Element & sensor)
{
  const bool within = std::abs(lidar.angle_min) <= kBeamAngleMax && std::abs(lidar.angle_max) <= kBeamAngleMax;
  if (!within || lidar.angle_min >= lidar.angle_max) {
    sensor.fail("<min_angle> has to be less than <max_angle>, both within two turns");
  }
  sensor.requireNotNegative("<range/min>", lidar.range_min);
  sensor.requireLength("<range/max>", lidar.range_max);
  if (lidar.range_min >= lidar.range_max) {
    sensor.fail("<range> has a <min> that is not less than its <max>");
  }
  sensor.requireNotNegative("<noise/stddev>", lidar.noise_stddev);
}

/// Standard deviation of a <noise>; it says its type as an attribute or as an element.
double stddevOf(const Element & noise)
{
  const bool is_none = noise.attribute("type") == "none" || noise.child("type").text() == "none";
  return noise && !is_none ? noise.notNegative("stddev", 0.0) : 0.0;
}

/// Noise of one quantity of an IMU; up to SDF 1.5 all axes had the same.
double imuNoise(const Element & imu, const char * quantity, const char * axis, const char * older)
{
  const Element noise = imu.child(quantity).child(axis).child("noise");
  return stddevOf(noise ? noise : imu.child("noise").child(older));
}

/// The frame that an IMU plugin names, or else the link that carries it.
std::string imuFrame(const Element & plugin, const CarContext & context)
{
  return context.frame(plugin, plugin.requiredText(plugin.child("frameName") ? "frameName" : "bodyName"));
}

void setImu(ImuDescription imu, const Element & element, CarContext & context)
{
  if (context.car.imu) {
    context.warnings.add("is a second IMU and left out", element.fileLine());
    return;
  }
  context.car.imu = std::move(imu);
}
}  // namespace

void readLidar(const SensorElement & element, CarContext & context)
{
  requireLevel(element);
  const Element & sensor = element.sensor;
  const Element ray = sensor.child("lidar") ? sensor.child("lidar") : sensor.child("ray");
  const Element horizontal = ray.child("scan").child("horizontal");
  if (!horizontal) {
    sensor.fail("has no <ray> with a <scan> and a <horizontal>");
  }
  LidarDescription lidar;
  lidar.name = sensor.name();
  lidar.topic = context.topic(element.plugin, element.plugin.requiredText("topicName"));
  lidar.frame = context.frame(element.plugin, element.plugin.requiredText("frameName"));
  lidar.pose = element.pose;
  lidar.rate_hz = sensor.positive("update_rate");
  lidar.beam_count = beamCount(sensor, horizontal);
  lidar.angle_min = horizontal.number("min_angle", 0.0);
  lidar.angle_max = horizontal.number("max_angle", 0.0);
  lidar.range_min = ray.number("range/min", 0.0);
  lidar.range_max = ray.number("range/max", 0.0);
  lidar.noise_mean = ray.number("noise/mean", 0.0);
  lidar.noise_stddev = stddevOf(ray.child("noise"));
  requireSound(lidar, sensor);
  if (ray.child("scan").child("vertical").child("samples") && ray.number("scan/vertical/samples") > 1.0) {
    context.warnings.add("<vertical> is left out: a lidar has one level layer", sensor.fileLine());
  }
  context.car.lidars.push_back(std::move(lidar));
}

void readBumper(const SensorElement & element, CarContext & context)
{
  BumperDescription bumper;
  bumper.name = element.sensor.name();
  bumper.topic = context.topic(element.plugin, element.plugin.requiredText("bumperTopicName"));
  bumper.frame = context.frame(element.plugin, element.plugin.requiredText("frameName"));
  bumper.rate_hz = element.sensor.notNegative("update_rate", 0.0);
  bumper.collision_names = collisionsOfContactSensor(element.sensor, context.car.solids);
  context.car.bumpers.push_back(std::move(bumper));
}

void readImu(const SensorElement & element, CarContext & context)
{
  const Element & plugin = element.plugin;
  const Element noise = element.sensor.child("imu");
  ImuDescription imu;
  imu.name = element.sensor.name();
  imu.topic = context.topic(plugin, plugin.requiredText("topicName"));
  imu.frame = imuFrame(plugin, context);
  imu.rate_hz = plugin.child("updateRateHZ") ? plugin.positive("updateRateHZ") : element.sensor.positive("update_rate");
  const double of_plugin = plugin.notNegative("gaussianNoise", 0.0);
  imu.yaw_rate_noise_stddev = std::hypot(of_plugin, imuNoise(noise, "angular_velocity", "z", "rate"));
  imu.acceleration_noise_stddev = std::hypot(of_plugin, imuNoise(noise, "linear_acceleration", "x", "accel"));
  setImu(std::move(imu), element.sensor, context);
}

void readImuPlugin(const Element & plugin, CarContext & context)
{
  ImuDescription imu;
  imu.name = plugin.name();
  imu.topic = context.topic(plugin, plugin.requiredText("topicName"));
  imu.frame = imuFrame(plugin, context);
  imu.rate_hz = plugin.positive("updateRate");
  imu.yaw_rate_noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  imu.acceleration_noise_stddev = imu.yaw_rate_noise_stddev;
  setImu(std::move(imu), plugin, context);
}
}  // namespace f1tenth_sim2d
