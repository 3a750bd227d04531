#include "loaders/car/car_readers.h"

#include <algorithm>
#include <functional>
#include <map>

#include "loaders/sensors/sensor_readers.h"
#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kJointStateRate = 100.0;  // Hz, the default of gazebo_ros_joint_state_publisher

void requireOffset(const PoseSensorDescription & sensor, const Element & plugin)
{
  if (const Element offset = plugin.child("xyzOffset")) {
    offset.requireNear(sensor.xyz_offset);
  }
  if (!sensor.rpy_offset.allFinite()) {
    const Element offset = plugin.child("rpyOffset");
    offset.fail("is '" + offset.text() + "', allowed are finite numbers");
  }
}

void readPoseSensor(const Element & plugin, CarContext & context)
{
  PoseSensorDescription sensor;
  sensor.name = plugin.name();
  sensor.topic = context.topic(plugin, plugin.requiredText("topicName"));
  sensor.frame = frameId(plugin, plugin.textOf("frameName", sensor.frame));
  sensor.link = frameId(plugin, plugin.requiredText("bodyName"));
  const auto link = context.model.link_poses.find(sensor.link);
  if (link == context.model.link_poses.end()) {
    plugin.fail("<bodyName> is '" + sensor.link + "', which is no link of the car");
  }
  sensor.pose = context.inCar(link->second);
  sensor.xyz_offset = plugin.vector("xyzOffset", sensor.xyz_offset);
  sensor.rpy_offset = plugin.vector("rpyOffset", sensor.rpy_offset);
  sensor.rate_hz = plugin.rate("updateRate", 0.0);
  sensor.noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  requireOffset(sensor, plugin);
  context.car.pose_sensors.push_back(std::move(sensor));
}

std::vector<std::string> namesIn(std::string list)
{
  std::replace(list.begin(), list.end(), ',', ' ');
  return wordsIn(list);
}

void requireNewCorner(const JointDescription & joint, const Element & publisher, const CarDescription & car)
{
  for (const JointDescription & other : car.joints) {
    if (other.name == joint.name) {
      publisher.fail("<jointName> names '" + joint.name + "' twice");
    }
    if (other.role == joint.role) {
      publisher.fail(
        "<jointName> names both '" + other.name + "' and '" + joint.name + "' at the same corner of the car");
    }
  }
}

void addJoint(
  const std::string & name, const std::vector<MechanismJoint> & mechanism, const Element & publisher,
  CarContext & context)
{
  const auto & joints = context.model.joints;
  if (std::none_of(joints.begin(), joints.end(), [&name](const JointPart & each) { return each.name == name; })) {
    publisher.fail("<jointName> names '" + name + "', which is no joint that moves");
  }
  const auto joint = std::find_if(
    mechanism.begin(), mechanism.end(), [&name](const MechanismJoint & each) { return each.description.name == name; });
  if (joint == mechanism.end()) {
    context.warnings.add(leftOut(name), publisher.fileLine());
    return;
  }
  requireNewCorner(joint->description, publisher, context.car);
  context.car.joints.push_back(joint->description);
}

/// Joints that a libgazebo_ros_joint_state_publisher.so names become those that joint_states carries.
void readJointStatePublisher(
  const Element & publisher, const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  context.car.joint_state_rate_hz = publisher.rate("updateRate", kJointStateRate);
  context.car.joint_state_topic = context.topic(publisher, "joint_states");
  for (const std::string & name : namesIn(publisher.requiredText("jointName"))) {
    addJoint(name, mechanism, publisher, context);
  }
}

void readRosControl(const Element & plugin, CarContext & context)
{
  if (context.car.ros_control) {
    context.warnings.add("is a second libgazebo_ros_control.so and left out", plugin.fileLine());
    return;
  }
  RosControlDescription control;
  control.ros_namespace = context.rosNamespace(plugin);
  control.control_period_sec = plugin.notNegative("controlPeriod", 0.0);
  context.car.ros_control = std::move(control);
}

void appendParameters(const Element & parent, const std::string & scope, PluginElement & plugin)
{
  for (const Element & child : parent.children()) {
    plugin.parameters.emplace_back(scope + child.tag(), child.text());
    appendParameters(child, scope + child.tag() + "/", plugin);
  }
}

/// Keeps a plugin that is not built in.
void keepPlugin(const Element & plugin, CarDescription & car)
{
  car.plugins.push_back({plugin.name(), plugin.attribute("filename"), plugin.path(), {}});
  appendParameters(plugin, "", car.plugins.back());
}

using Read = std::function<void(const Element &)>;

std::map<std::string, Read> builtIn(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  const auto drive = [&context](DriveDescription::Kind kind) {
    return [&context, kind](const Element & plugin) { readDrive(kind, plugin, context); };
  };
  using Kind = DriveDescription::Kind;
  return {
    {"libgazebo_ros_joint_state_publisher.so",
     [&](const Element & plugin) { readJointStatePublisher(plugin, mechanism, context); }},
    {"libgazebo_ros_imu.so", [&](const Element & plugin) { readImuPlugin(plugin, context); }},
    {"libhector_gazebo_ros_imu.so", [&](const Element & plugin) { readHectorImuPlugin(plugin, context); }},
    {"libgazebo_ros_p3d.so", [&](const Element & plugin) { readPoseSensor(plugin, context); }},
    {"libgazebo_ros_control.so", [&](const Element & plugin) { readRosControl(plugin, context); }},
    {"libgazebo_ros_ackermann_drive.so", drive(Kind::kAckermann)},
    {"libgazebo_ros_diff_drive.so", drive(Kind::kDifferential)},
    {"libgazebo_ros_skid_steer_drive.so", drive(Kind::kSkidSteer)},
    {"libgazebo_ros_planar_move.so", drive(Kind::kPlanarMove)},
  };
}

/// Controllers move wheels and steering joints whatever their transmissions say: only what is not simulated is named.
void warnOfTransmissions(const CarContext & context)
{
  for (const Element & transmission : context.model.transmissions) {
    const std::string type =
      transmission.has("type") ? transmission.attribute("type") : transmission.child("type").text();
    const std::string name = transmission.child("joint").name();
    const auto & joints = context.car.mechanism;
    const auto is_meant = [&name](const JointDescription & joint) { return joint.name == name; };
    if (type.substr(type.find_last_of('/') + 1) != "SimpleTransmission") {
      context.warnings.add(
        "a transmission of type '" + type + "' is left out: simulated is SimpleTransmission", transmission.fileLine());
    } else if (std::none_of(joints.begin(), joints.end(), is_meant)) {
      context.warnings.add(leftOut(name), transmission.fileLine());
    }
  }
}
}  // namespace

void readPlugins(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  const std::map<std::string, Read> readers = builtIn(mechanism, context);
  for (const Element & plugin : context.model.plugins) {
    const auto reader = readers.find(libraryName(plugin));
    if (reader != readers.end()) {
      reader->second(plugin);
    } else if (libraryName(plugin).empty()) {
      context.warnings.add("has no attribute 'filename' and is left out", plugin.fileLine());
    } else {
      keepPlugin(plugin, context.car);
    }
  }
  warnOfTransmissions(context);
}
}  // namespace f1tenth_sim2d
