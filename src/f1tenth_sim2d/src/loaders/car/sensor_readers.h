#pragma once

#include <sdf/Sensor.hh>

#include "loaders/car/car_context.h"
#include "loaders/sdf/element_reader.h"

namespace f1tenth_sim2d
{
/// A sensor, the plugin that publishes it, and where it is.
struct SensorElement
{
  const sdf::Sensor & sensor;
  sdf::ElementPtr plugin;
  Pose3 pose;  ///< in the frame of the car

  ElementReader reader(const CarContext & context) const { return {sensor.Element(), context.source()}; }
  ElementReader pluginReader(const CarContext & context) const { return {plugin, context.source()}; }
};

/// Each adds one sensor to the car.
/// @throws LoadError
void readLidar(const SensorElement & element, CarContext & context);
void readBumper(const SensorElement & element, CarContext & context);
void readImu(const SensorElement & element, CarContext & context);

/// Takes a libgazebo_ros_imu.so of the model as the car's IMU.
/// @throws LoadError
void readImuPlugin(const sdf::ElementPtr & plugin, CarContext & context);
}  // namespace f1tenth_sim2d
