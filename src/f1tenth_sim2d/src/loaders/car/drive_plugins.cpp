#include "loaders/car/drive_plugins.h"

#include <map>

namespace f1tenth_sim2d
{
namespace
{
using Kind = DriveDescription::Kind;

/// What a kind of plugin calls its parameters, and the rate that it takes if none is given.
struct Tags
{
  const char * command_topic;
  const char * odometry_topic;
  const char * odometry_frame;
  const char * base_frame;
  const char * rate;
  const char * odometry;   ///< whether to publish it; null: always
  const char * transform;  ///< whether to publish it; null: always
  double default_rate_hz;
};

const Tags & tagsOf(Kind kind)
{
  static const std::map<Kind, Tags> tags{
    {Kind::kAckermann,
     {"commandTopic", "odometryTopic", "odometry_frame", "robot_base_frame", "update_rate", "publish_odom",
      "publish_odom_tf", 100.0}},
    {Kind::kDifferential,
     {"commandTopic", "odometryTopic", "odometryFrame", "robotBaseFrame", "updateRate", nullptr, "publishTf", 100.0}},
    {Kind::kSkidSteer,
     {"commandTopic", "odometryTopic", "odometryFrame", "robotBaseFrame", "updateRate", nullptr, "broadcastTF", 100.0}},
    {Kind::kPlanarMove,
     {"commandTopic", "odometryTopic", "odometryFrame", "robotBaseFrame", "odometryRate", nullptr, nullptr, 20.0}},
  };
  return tags.at(kind);
}

bool flag(const sdf::ElementPtr & element, const char * tag)
{
  return tag == nullptr || element->Get<bool>(tag, true).first;
}

/// The plugins of ROS 2 have one tag <ros> with a <namespace> and <remapping>FROM:=TO</remapping>.
std::string remapped(const sdf::ElementPtr & element, const std::string & topic)
{
  const sdf::ElementPtr ros = descend(element, {"ros"});
  for (auto tag = ros ? ros->FindElement("remapping") : nullptr; tag; tag = tag->GetNextElement("remapping")) {
    const std::string rule = withoutBlanksAround(tag->Get<std::string>());
    if (rule.rfind(topic + ":=", 0) == 0) {
      return rule.substr(topic.size() + 2);
    }
  }
  return topic;
}
}  // namespace

void readDrive(Kind kind, const sdf::ElementPtr & element, CarContext & context)
{
  if (context.car.drive) {
    context.warnings.add("is a second plugin that drives the car and left out", elementPath(element));
    return;
  }
  const Tags & tags = tagsOf(kind);
  const ElementReader plugin(element, context.source());
  DriveDescription drive;
  drive.kind = kind;
  drive.name = element->Get<std::string>("name");
  drive.command_topic = context.topic(element, remapped(element, plugin.text(tags.command_topic, "cmd_vel")));
  drive.odometry_topic = context.topic(element, remapped(element, plugin.text(tags.odometry_topic, "odom")));
  drive.odometry_frame = context.withoutPrefix(plugin.text(tags.odometry_frame, "odom"));
  drive.base_frame = context.withoutPrefix(context.originalText(element, tags.base_frame, "base_footprint"));
  drive.odometry_rate_hz = plugin.notNegative(tags.rate, tags.default_rate_hz);
  drive.publishes_odometry = flag(element, tags.odometry);
  drive.publishes_transform = flag(element, tags.transform);
  if (const double limit = plugin.notNegative("wheelAcceleration", 0.0); kind == Kind::kDifferential && limit > 0.0) {
    drive.acceleration_max = limit;
  }
  context.car.drive = std::move(drive);
}
}  // namespace f1tenth_sim2d
