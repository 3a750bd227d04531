#pragma once

#include <string>

#include "loaders/model/car_context.h"

namespace f1tenth_sim2d
{
/// A sensor, the plugin that publishes it, and where it is.
struct SensorElement
{
  Element sensor;
  Element plugin;
  Pose3 pose;        ///< in the frame of the car
  std::string link;  ///< on which it is
};

/// Each adds one sensor to the car.
/// @throws LoadError
void readLidar(const SensorElement & element, CarContext & context);
void readSonar(const SensorElement & element, CarContext & context);
void readBumper(const SensorElement & element, CarContext & context);
void readImu(const SensorElement & element, CarContext & context);

/// Takes a libgazebo_ros_imu.so of the model as the car's IMU.
/// @throws LoadError
void readImuPlugin(const Element & plugin, CarContext & context);

/// The same of a libhector_gazebo_ros_imu.so.
/// @throws LoadError
void readHectorImuPlugin(const Element & plugin, CarContext & context);
}  // namespace f1tenth_sim2d
