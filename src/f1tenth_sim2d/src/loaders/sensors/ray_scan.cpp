#include "loaders/sensors/ray_scan.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
/// rad; more than the error of rounding to three digits (3.14 for pi), less than anyone tilts a sensor on purpose.
constexpr double kLevelTolerance = 2e-3;
constexpr double kTilt = 1e-9;          // rad, from which on it is worth removing
constexpr double kAngleMax = 12.56637;  // rad, two turns: rays beyond one look where others look
constexpr int kCountMax = 100'000;

/// The pose of a sensor, without the tilt due to rounding.
Pose3 levelPose(const SensorElement & element, const char * what)
{
  const Pose3 & pose = element.pose;
  const Eigen::Vector3d up = pose.up();
  const double tilt = maths::hypot(up.x(), up.y());
  if (tilt > kLevelTolerance) {
    element.sensor.fail(std::string("is tilted; ") + what + " has to be level, upright or upside down");
  }
  return tilt > kTilt ? Pose3(pose.position, Pose3::rotationOf(up.z() < 0.0 ? M_PI : 0.0, 0.0, pose.yaw())) : pose;
}

/// Rays of a scan line, including those between the samples.
int rayCount(const Element & sensor, const Element & horizontal)
{
  const double count = horizontal.number("samples", 640.0) * horizontal.number("resolution", 1.0);
  if (!(count >= 1.0 && count <= kCountMax)) {
    sensor.fail("has " + toText(count) + " <samples>, allowed are 1 to " + std::to_string(kCountMax));
  }
  return static_cast<int>(std::lround(count));
}

void requireSound(const RayScan & scan, const Element & sensor)
{
  const bool within = std::abs(scan.angle_min) <= kAngleMax && std::abs(scan.angle_max) <= kAngleMax;
  if (!within || (scan.count > 1 && scan.angle_min >= scan.angle_max)) {
    sensor.fail("<min_angle> has to be less than <max_angle>, both within two turns");
  }
  sensor.requireNotNegative("<range/min>", scan.range_min);
  sensor.requireLength("<range/max>", scan.range_max);
  if (scan.range_min >= scan.range_max) {
    sensor.fail("<range> has a <min> that is not less than its <max>");
  }
}
}  // namespace

RayScan readRayScan(const SensorElement & element, const char * what, WarningCollector & warnings)
{
  const Element & sensor = element.sensor;
  const Element ray = sensor.child("lidar") ? sensor.child("lidar") : sensor.child("ray");
  const Element horizontal = ray.child("scan").child("horizontal");
  if (!horizontal) {
    sensor.fail("has no <ray> with a <scan> and a <horizontal>");
  }
  RayScan scan;
  scan.ray = ray;
  scan.pose = levelPose(element, what);
  scan.count = rayCount(sensor, horizontal);
  scan.angle_min = horizontal.number("min_angle", 0.0);
  scan.angle_max = horizontal.number("max_angle", 0.0);
  scan.range_min = ray.number("range/min", 0.0);
  scan.range_max = ray.number("range/max", 0.0);
  requireSound(scan, sensor);
  if (ray.child("scan").child("vertical").child("samples") && ray.number("scan/vertical/samples") > 1.0) {
    warnings.add(std::string("<vertical> is left out: ") + what + " has one level layer", sensor.fileLine());
  }
  return scan;
}
}  // namespace f1tenth_sim2d
