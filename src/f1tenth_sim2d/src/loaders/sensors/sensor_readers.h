#pragma once

#include <string>
#include <vector>

#include "loaders/model/car_context.h"

namespace f1tenth_sim2d
{
/// Fills in the car's sensors from those of its links. Needs the car's solids.
/// @throws LoadError
void readSensors(CarContext & context);

/// A sensor, the plugin that publishes it, and where it is.
struct SensorElement
{
  Element sensor;
  Element plugin;
  Pose3 pose;        ///< in the frame of the car
  std::string link;  ///< on which it is
};

/// A topic and the frame of a plugin; what it does not say is taken as gazebo_ros takes it, with a warning.
/// @throws LoadError, as readers do
std::string topicOf(const Element & plugin, const char * tag, const char * by_default, CarContext & context);
std::string frameOf(const Element & plugin, CarContext & context);
/// Name, topic, frame, pose and rate of a sensor whose tags have the usual names: <topicName> and <frameName> of its
/// plugin, <update_rate> of its own. A reader of a sensor gets it and adds a component to the car.
/// @param topic  where it publishes by default
/// @throws LoadError, as readers do
Mount mountOf(const SensorElement & element, const char * topic, CarContext & context);
/// Hz: the lower rate of sensor and plugin, if both are given.
double publishingRate(const SensorElement & element);
/// Standard deviation of a <noise>; 0 if there is none.
double stddevOf(const Element & noise);

/// Scoped names of the solids that a contact sensor watches: for each name a collision of the sensor's own link, or
/// else the only one of another link; for a name with a scope ("LINK::COLLISION") that of the link. A collision may be
/// named as in the URDF, although joining links that are fixed to each other has renamed it.
/// @param link  on which the sensor is
/// @throws LoadError for a name that no solid has, or solids of several other links
std::vector<std::string> collisionsOfContactSensor(
  const Element & sensor, const std::string & link, const CarContext & context);

/// Takes a libgazebo_ros_imu.so of the model as the car's IMU.
/// @throws LoadError
void readImuPlugin(const Element & plugin, CarContext & context);

/// The same for a libhector_gazebo_ros_imu.so.
/// @throws LoadError
void readHectorImuPlugin(const Element & plugin, CarContext & context);
}  // namespace f1tenth_sim2d
