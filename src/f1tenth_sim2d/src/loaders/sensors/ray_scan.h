#pragma once

#include "loaders/sensors/sensor_readers.h"

namespace f1tenth_sim2d
{
/// Where a sensor of type ray looks: level rays from it, at equal angles.
struct RayScan
{
  Element ray;  ///< the <ray> or <lidar>
  Pose3 pose;   ///< of the sensor in the frame of the car; upside down its angles count clockwise
  int count{0};
  double angle_min{0.0};  ///< rad, of the first ray
  double angle_max{0.0};  ///< rad, of the last one
  double range_min{0.0};  ///< m
  double range_max{0.0};  ///< m
};

/// @param what  the sensor that it belongs to, for messages: "a lidar"
/// @throws LoadError for a sensor that is tilted, and for numbers that are out of their bounds
RayScan readRayScan(const SensorElement & element, const char * what, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
