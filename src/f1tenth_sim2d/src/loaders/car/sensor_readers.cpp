#include "loaders/car/sensor_readers.h"

#include <cmath>
#include <sdf/Imu.hh>
#include <sdf/Lidar.hh>
#include <sstream>

#include "loaders/car/contact_sensor.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

/// rad; more than angles rounded to three digits, less than anyone tilts a lidar on purpose.
constexpr double kLevelTolerance = 1e-3;
constexpr double kBeamAngleMax = 12.56637;  // rad, two turns: beams beyond one look where others look
constexpr int kBeamCountMax = 100'000;

double rate(const SensorElement & element, const CarContext & context)
{
  return element.reader(context).positive("update_rate");
}

void requireLevel(const SensorElement & element, const CarContext & context)
{
  const Vector3d up = element.pose.up();
  if (up.z() < 0.0 || std::hypot(up.x(), up.y()) > kLevelTolerance) {
    element.reader(context).fail("is tilted; a lidar has to be level, with its z axis upwards");
  }
}

/// Beams of a scan line; those between the samples count.
int beamCount(const sdf::Lidar & scan, const ElementReader & reader)
{
  const double count = scan.HorizontalScanSamples() * scan.HorizontalScanResolution();
  if (!(count >= 2.0 && count <= kBeamCountMax)) {
    std::ostringstream message;
    message << "has " << count << " <samples>, allowed are 2 to " << kBeamCountMax;
    reader.fail(message.str());
  }
  return static_cast<int>(std::lround(count));
}

void requireSound(const LidarDescription & lidar, const ElementReader & reader)
{
  const bool within = std::abs(lidar.angle_min) <= kBeamAngleMax && std::abs(lidar.angle_max) <= kBeamAngleMax;
  if (!within || lidar.angle_min >= lidar.angle_max) {
    reader.fail("<min_angle> has to be less than <max_angle>, both within two turns");
  }
  reader.requireNotNegative("range/min", lidar.range_min);
  reader.requireLength("range/max", lidar.range_max);
  if (lidar.range_min >= lidar.range_max) {
    reader.fail("<range> has a <min> that is not less than its <max>");
  }
  reader.requireNotNegative("noise/stddev", lidar.noise_stddev);
}

/// The frame that an IMU plugin names, or else the link that carries it.
std::string imuFrame(const sdf::ElementPtr & plugin, const CarContext & context)
{
  const std::string given = plugin->HasElement("frameName") ? "frameName" : "bodyName";
  ElementReader(plugin, context.source()).requiredText(given);
  return context.withoutPrefix(context.originalText(plugin, given, ""));
}

void setImu(ImuDescription imu, const sdf::ElementPtr & element, CarContext & context)
{
  if (context.car.imu) {
    context.warnings.add("is a second IMU and left out", elementPath(element));
    return;
  }
  context.car.imu = std::move(imu);
}
}  // namespace

void readLidar(const SensorElement & element, CarContext & context)
{
  requireLevel(element, context);
  const sdf::Lidar & scan = *element.sensor.LidarSensor();
  const ElementReader plugin = element.pluginReader(context);
  LidarDescription lidar;
  lidar.name = element.sensor.Name();
  lidar.topic = context.topic(element.plugin, plugin.requiredText("topicName"));
  lidar.frame = context.withoutPrefix(plugin.requiredText("frameName"));
  lidar.pose = element.pose;
  lidar.rate_hz = rate(element, context);
  lidar.beam_count = beamCount(scan, element.reader(context));
  lidar.angle_min = scan.HorizontalScanMinAngle().Radian();
  lidar.angle_max = scan.HorizontalScanMaxAngle().Radian();
  lidar.range_min = scan.RangeMin();
  lidar.range_max = scan.RangeMax();
  lidar.noise_mean = scan.LidarNoise().Mean();
  lidar.noise_stddev = scan.LidarNoise().StdDev();
  requireSound(lidar, element.reader(context));
  if (scan.VerticalScanSamples() > 1) {
    context.warnings.add("<vertical> is left out: a lidar has one level layer", elementPath(element.sensor.Element()));
  }
  context.car.lidars.push_back(std::move(lidar));
}

void readBumper(const SensorElement & element, CarContext & context)
{
  const ElementReader plugin = element.pluginReader(context);
  BumperDescription bumper;
  bumper.name = element.sensor.Name();
  bumper.topic = context.topic(element.plugin, plugin.requiredText("bumperTopicName"));
  bumper.frame = context.withoutPrefix(plugin.requiredText("frameName"));
  bumper.rate_hz = rate(element, context);
  bumper.collision_names = collisionsOfContactSensor(element.sensor.Element(), context.car.solids, context.source());
  context.car.bumpers.push_back(std::move(bumper));
}

void readImu(const SensorElement & element, CarContext & context)
{
  const ElementReader plugin = element.pluginReader(context);
  const sdf::Imu & noise = *element.sensor.ImuSensor();
  ImuDescription imu;
  imu.name = element.sensor.Name();
  imu.topic = context.topic(element.plugin, plugin.requiredText("topicName"));
  imu.frame = imuFrame(element.plugin, context);
  imu.rate_hz = element.plugin->HasElement("updateRateHZ") ? plugin.positive("updateRateHZ") : rate(element, context);
  const double of_plugin = plugin.notNegative("gaussianNoise", 0.0);
  imu.yaw_rate_noise_stddev = std::hypot(of_plugin, noise.AngularVelocityZNoise().StdDev());
  imu.acceleration_noise_stddev = std::hypot(of_plugin, noise.LinearAccelerationXNoise().StdDev());
  plugin.requireNotNegative("angular_velocity/z/noise/stddev", noise.AngularVelocityZNoise().StdDev());
  plugin.requireNotNegative("linear_acceleration/x/noise/stddev", noise.LinearAccelerationXNoise().StdDev());
  setImu(std::move(imu), element.sensor.Element(), context);
}

void readImuPlugin(const sdf::ElementPtr & element, CarContext & context)
{
  const ElementReader plugin(element, context.source());
  ImuDescription imu;
  imu.name = element->Get<std::string>("name");
  imu.topic = context.topic(element, plugin.requiredText("topicName"));
  imu.frame = imuFrame(element, context);
  imu.rate_hz = plugin.positive("updateRate");
  imu.yaw_rate_noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  imu.acceleration_noise_stddev = imu.yaw_rate_noise_stddev;
  setImu(std::move(imu), element, context);
}
}  // namespace f1tenth_sim2d
