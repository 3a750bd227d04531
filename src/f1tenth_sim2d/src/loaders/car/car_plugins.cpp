#include "loaders/car/car_plugins.h"

#include <functional>
#include <map>

#include "loaders/car/car_joints.h"
#include "loaders/car/drive_plugins.h"
#include "loaders/car/sensor_readers.h"
#include "loaders/sdf/sdf_models.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

void readPoseSensor(const sdf::ElementPtr & element, CarContext & context)
{
  const ElementReader plugin(element, context.source());
  PoseSensorDescription sensor;
  sensor.name = element->Get<std::string>("name");
  sensor.topic = context.topic(element, plugin.requiredText("topicName"));
  sensor.frame = context.originalText(element, "frameName", sensor.frame);
  plugin.requireGiven("bodyName");
  sensor.link = context.withoutPrefix(context.originalText(element, "bodyName", ""));
  const auto link = context.facts.link_poses.find(sensor.link);
  if (link == context.facts.link_poses.end()) {
    plugin.fail("<bodyName> is '" + sensor.link + "', which is no link of the car");
  }
  sensor.pose = context.inCar(link->second);
  sensor.xyz_offset = plugin.vector(context.originalText(element, "xyzOffset", "0 0 0"), "xyzOffset");
  sensor.rpy_offset = plugin.vector(context.originalText(element, "rpyOffset", "0 0 0"), "rpyOffset");
  sensor.rate_hz = plugin.notNegative("updateRate", 0.0);
  sensor.noise_stddev = plugin.notNegative("gaussianNoise", 0.0);
  context.car.pose_sensors.push_back(std::move(sensor));
}

void readRosControl(const sdf::ElementPtr & element, CarContext & context)
{
  if (context.car.ros_control) {
    context.warnings.add("is a second libgazebo_ros_control.so and left out", elementPath(element));
    return;
  }
  const ElementReader plugin(element, context.source());
  RosControlDescription control;
  control.ros_namespace = context.rosNamespace(element);
  control.robot_param = plugin.text("robotParam", control.robot_param);
  control.control_period_sec = plugin.notNegative("controlPeriod", 0.0);
  context.car.ros_control = std::move(control);
}

using Read = std::function<void(const sdf::ElementPtr &)>;

std::map<std::string, Read> builtIn(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  const auto drive = [&context](DriveDescription::Kind kind) {
    return [&context, kind](const sdf::ElementPtr & element) { readDrive(kind, element, context); };
  };
  using Kind = DriveDescription::Kind;
  return {
    {"libgazebo_ros_joint_state_publisher.so",
     [&](const sdf::ElementPtr & element) { readJointStatePublisher(element, mechanism, context); }},
    {"libgazebo_ros_imu.so", [&](const sdf::ElementPtr & element) { readImuPlugin(element, context); }},
    {"libgazebo_ros_p3d.so", [&](const sdf::ElementPtr & element) { readPoseSensor(element, context); }},
    {"libgazebo_ros_control.so", [&](const sdf::ElementPtr & element) { readRosControl(element, context); }},
    {"libgazebo_ros_ackermann_drive.so", drive(Kind::kAckermann)},
    {"libgazebo_ros_diff_drive.so", drive(Kind::kDifferential)},
    {"libgazebo_ros_skid_steer_drive.so", drive(Kind::kSkidSteer)},
    {"libgazebo_ros_planar_move.so", drive(Kind::kPlanarMove)},
  };
}

/// Transmissions of joints that are no wheel or steering joint move nothing here.
void readTransmissionsOfMechanism(CarContext & context)
{
  for (const TransmissionDescription & transmission : context.facts.transmissions) {
    bool is_ours = false;
    for (const JointDescription & joint : context.car.mechanism) {
      is_ours = is_ours || joint.name == transmission.joint;
    }
    if (is_ours) {
      context.car.transmissions.push_back(transmission);
    } else {
      context.warnings.add(
        "joint '" + transmission.joint + "' is left out: neither a wheel nor a steering joint",
        "robot/transmission[" + transmission.name + "]");
    }
  }
}
}  // namespace

void readPlugins(const std::vector<MechanismJoint> & mechanism, CarContext & context)
{
  const std::map<std::string, Read> readers = builtIn(mechanism, context);
  for (auto element = context.model.Element()->FindElement("plugin"); element;
       element = element->GetNextElement("plugin")) {
    const auto reader = readers.find(libraryName(element));
    if (reader != readers.end()) {
      reader->second(element);
    } else {
      context.car.plugins.push_back(readPlugin(element));
    }
  }
  readTransmissionsOfMechanism(context);
}
}  // namespace f1tenth_sim2d
