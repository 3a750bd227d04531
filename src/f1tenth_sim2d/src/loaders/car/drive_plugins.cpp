#include "loaders/car/car_readers.h"

#include <map>

namespace f1tenth_sim2d
{
namespace
{
using Kind = DriveDescription::Kind;

/// Names of the parameters of a kind of plugin, and its default rate.
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

bool flag(const Element & plugin, const char * tag)
{
  return tag == nullptr || plugin.flag(tag, true);
}

/// The plugins of ROS 2 have one tag <ros> with a <namespace> and <remapping>FROM:=TO</remapping>.
std::string remapped(const Element & plugin, const std::string & topic)
{
  for (const Element & remapping : plugin.child("ros").children("remapping")) {
    const std::string rule = remapping.text();
    if (rule.rfind(topic + ":=", 0) == 0) {
      if (rule.size() == topic.size() + 2) {
        remapping.fail("is '" + rule + "', allowed is FROM:=TO");
      }
      return rule.substr(topic.size() + 2);
    }
  }
  return topic;
}

/// A topic after the <remapping> and in the <namespace>.
std::string resolved(const Element & plugin, const std::string & given)
{
  const std::string topic = remapped(plugin, given);
  const std::string space = plugin.child("ros").child("namespace").text();
  if (space.empty() || topic.front() == '/') {
    return topic;
  }
  return (space.front() == '/' ? "" : "/") + space + (space.back() == '/' ? "" : "/") + topic;
}
}  // namespace

void readDrive(Kind kind, const Element & plugin, CarContext & context)
{
  if (context.car.drive) {
    context.warnings.add("is a second plugin that drives the car and left out", plugin.fileLine());
    return;
  }
  const bool has_older_tags =
    kind == Kind::kAckermann && (plugin.child("odometryFrame") || plugin.child("robotBaseFrame") ||
                                 plugin.child("updateRate") || plugin.child("publishTf"));
  const Tags & tags = tagsOf(has_older_tags ? Kind::kDifferential : kind);
  DriveDescription drive;
  drive.kind = kind;
  drive.command_topic = context.topic(plugin, resolved(plugin, plugin.textOf(tags.command_topic, "cmd_vel")));
  drive.odometry_topic = context.topic(plugin, resolved(plugin, plugin.textOf(tags.odometry_topic, "odom")));
  drive.odometry_frame = frameId(plugin, plugin.textOf(tags.odometry_frame, "odom"));
  drive.base_frame = frameId(plugin, plugin.textOf(tags.base_frame, "base_footprint"));
  drive.odometry_rate_hz = plugin.rate(tags.rate, tags.default_rate_hz);
  drive.publishes_odometry = flag(plugin, tags.odometry);
  drive.publishes_transform = flag(plugin, tags.transform);
  if (const double limit = plugin.notNegative("wheelAcceleration", 0.0); kind == Kind::kDifferential && limit > 0.0) {
    drive.acceleration_max = limit;
  }
  if (kind == Kind::kAckermann) {
    drive.steering_max = plugin.notNegative("max_steer", drive.steering_max);
    drive.speed_max = plugin.notNegative("max_speed", drive.speed_max);
  }
  context.car.drive = std::move(drive);
}
}  // namespace f1tenth_sim2d
