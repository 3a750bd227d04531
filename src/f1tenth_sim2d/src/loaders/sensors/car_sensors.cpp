#include "loaders/sensors/sensor_readers.h"

#include <algorithm>
#include <set>

namespace f1tenth_sim2d
{
// Each reads one sensor, in a file of its own, and adds it to the car.
void readLidar(const SensorElement & element, CarContext & context);
void readSonar(const SensorElement & element, CarContext & context);
void readBumper(const SensorElement & element, CarContext & context);
void readImu(const SensorElement & element, CarContext & context);
void readCamera(const SensorElement & element, CarContext & context);

namespace
{
struct SensorKind
{
  std::set<std::string> types;
  std::vector<std::string> libraries;  ///< that publish it
  void (*read)(const SensorElement &, CarContext &);
  bool without_plugin{false};  ///< whether it is of use then
};

const std::vector<SensorKind> & sensorKinds()
{
  static const std::set<std::string> kRayTypes{"ray", "gpu_ray", "lidar", "gpu_lidar"};
  static const std::vector<SensorKind> kinds{
    {kRayTypes, {"libgazebo_ros_laser.so", "libgazebo_ros_gpu_laser.so"}, readLidar},
    {kRayTypes, {"libgazebo_ros_range.so"}, readSonar},
    {{"contact"}, {"libgazebo_ros_bumper.so"}, readBumper},
    {{"imu"}, {"libgazebo_ros_imu_sensor.so", "libgazebo_ros_imu.so"}, readImu},
    {{"camera", "depth", "depth_camera", "multicamera", "rgbd", "rgbd_camera"},
     {"libgazebo_ros_camera.so", "libgazebo_ros_multicamera.so", "libgazebo_ros_depth_camera.so",
      "libgazebo_ros_openni_kinect.so", "libgazebo_ros_triggered_camera.so", "libgazebo_ros_triggered_multicamera.so"},
     readCamera,
     true},
  };
  return kinds;
}

/// Types of SDF that are not simulated.
const std::set<std::string> kOtherTypes{
  "air_pressure",
  "altimeter",
  "custom",
  "force_torque",
  "gps",
  "logical_camera",
  "magnetometer",
  "navsat",
  "none",
  "rfid",
  "rfidtag",
  "sonar",
  "wideanglecamera",
  "wireless_receiver",
  "wireless_transmitter"};

Element findPlugin(const Element & sensor, const std::vector<std::string> & libraries)
{
  for (const Element & plugin : sensor.children("plugin")) {
    if (std::find(libraries.begin(), libraries.end(), libraryName(plugin)) != libraries.end()) {
      return plugin;
    }
  }
  return {};
}

std::string whyLeftOut(const std::string & type)
{
  return kOtherTypes.count(type) > 0 ? "a sensor of type " + type + " is left out: not simulated"
                                     : "is no type of sensor of SDF and left out";
}

void readSensor(const SensorPart & sensor, const std::string & link, CarContext & context)
{
  const std::string type = sensor.element.attribute("type");
  std::string publishers;
  for (const SensorKind & kind : sensorKinds()) {
    if (kind.types.count(type) == 0) {
      continue;
    }
    if (const Element plugin = findPlugin(sensor.element, kind.libraries); plugin || kind.without_plugin) {
      kind.read({sensor.element, plugin, context.inCar(sensor.pose), link}, context);
      return;
    }
    for (const std::string & library : kind.libraries) {
      publishers += (publishers.empty() ? "" : " or ") + library;
    }
  }
  context.warnings.add(
    publishers.empty() ? whyLeftOut(type) : "has no <plugin> " + publishers + " to publish it and is left out",
    sensor.element.fileLine());
}
}  // namespace

void readSensors(CarContext & context)
{
  std::set<std::string> names;
  for (const LinkPart & link : context.model.links) {
    for (const SensorPart & sensor : link.sensors) {
      if (!names.insert(sensor.element.name()).second) {
        sensor.element.fail("this name is taken; names are unique among the sensors of a car");
      }
      readSensor(sensor, link.name, context);
    }
  }
}
}  // namespace f1tenth_sim2d
