#include "loaders/car/car_sensors.h"

#include <algorithm>
#include <sdf/Link.hh>
#include <set>

#include "f1tenth_sim2d/errors.h"
#include "loaders/car/sensor_readers.h"
#include "loaders/sdf/sdf_models.h"

namespace f1tenth_sim2d
{
namespace
{

const std::vector<std::string> kLidarLibraries{"libgazebo_ros_laser.so", "libgazebo_ros_gpu_laser.so"};
const std::vector<std::string> kBumperLibraries{"libgazebo_ros_bumper.so"};
const std::vector<std::string> kImuLibraries{"libgazebo_ros_imu_sensor.so", "libgazebo_ros_imu.so"};

sdf::ElementPtr findPlugin(const sdf::Sensor & sensor, const std::vector<std::string> & libraries)
{
  for (auto plugin = sensor.Element()->FindElement("plugin"); plugin; plugin = plugin->GetNextElement("plugin")) {
    if (std::find(libraries.begin(), libraries.end(), libraryName(plugin)) != libraries.end()) {
      return plugin;
    }
  }
  return nullptr;
}

std::string joinedByOr(const std::vector<std::string> & libraries)
{
  std::string text;
  for (const std::string & library : libraries) {
    text += (text.empty() ? "" : " or ") + library;
  }
  return text;
}

struct SensorKind
{
  std::set<sdf::SensorType> types;
  const std::vector<std::string> & libraries;
  void (*read)(const SensorElement &, CarContext &);
};

const std::vector<SensorKind> & sensorKinds()
{
  static const std::vector<SensorKind> kinds{
    {{sdf::SensorType::LIDAR, sdf::SensorType::GPU_LIDAR}, kLidarLibraries, readLidar},
    {{sdf::SensorType::CONTACT}, kBumperLibraries, readBumper},
    {{sdf::SensorType::IMU}, kImuLibraries, readImu},
  };
  return kinds;
}

void readSensor(const sdf::Sensor & sensor, const Pose3 & pose, CarContext & context)
{
  const std::string place = elementPath(sensor.Element());
  for (const SensorKind & kind : sensorKinds()) {
    if (kind.types.count(sensor.Type()) == 0) {
      continue;
    }
    if (const sdf::ElementPtr plugin = findPlugin(sensor, kind.libraries)) {
      kind.read({sensor, plugin, pose}, context);
    } else {
      context.warnings.add("has no <plugin> " + joinedByOr(kind.libraries) + " to publish it and is left out", place);
    }
    return;
  }
  const auto type = sensor.Element()->Get<std::string>("type");
  const bool is_camera = type.find("camera") != std::string::npos;
  context.warnings.add(
    "a sensor of type " + type + " is left out: " + (is_camera ? "in 2-D it has nothing to see" : "not simulated"),
    place);
}

void requireNewName(const sdf::Sensor & sensor, std::set<std::string> & names, const CarContext & context)
{
  if (!names.insert(sensor.Name()).second) {
    throw LoadError(
      context.source(), elementPath(sensor.Element()),
      "this name is taken; names are unique among the sensors of a car");
  }
}
}  // namespace

void readSensors(CarContext & context)
{
  std::set<std::string> names;
  for (std::uint64_t i = 0; i < context.model.LinkCount(); ++i) {
    const sdf::Link & link = *context.model.LinkByIndex(i);
    const Pose3 link_pose = resolvePose(link.SemanticPose(), "__model__", link.Element(), context.source());
    for (std::uint64_t k = 0; k < link.SensorCount(); ++k) {
      const sdf::Sensor & sensor = *link.SensorByIndex(k);
      requireNewName(sensor, names, context);
      const Pose3 in_link = resolvePose(sensor.SemanticPose(), "", sensor.Element(), context.source());
      readSensor(sensor, context.inCar(link_pose * in_link), context);
    }
  }
}
}  // namespace f1tenth_sim2d
