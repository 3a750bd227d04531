#include "workspace_support/lidar_inputs.h"

#include <cstdint>

namespace workspace_support
{
namespace
{
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();
const ros::WallDuration kSettling{0.1};
constexpr std::uint32_t kNoLimit = 0;  // of messages that wait
}  // namespace

ros::NodeHandle servedBy(ros::CallbackQueue & queue)
{
  ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  return node;
}

// Without a limit: what is waiting in lockstep must not be lost, and a node that was busy for a while must know all
// transforms of that time (a tf2_ros::TransformListener keeps 100): missing ones are interpolated in a straight line.
LidarInputs::LidarInputs(ros::CallbackQueue & queue, tf2::BufferCore & transforms, const OnScan & on_scan)
: node_(servedBy(queue)),
  transforms_(transforms),
  on_scan_(on_scan),
  moving_transforms_(subscribeToTransforms("/tf", false)),
  static_transforms_(subscribeToTransforms("/tf_static", true)),
  scans_(node_.subscribe("scan", kNoLimit, &LidarInputs::hear, this, kNoDelay))
{
}

ros::Subscriber LidarInputs::subscribeToTransforms(const std::string & topic, bool are_static)
{
  const boost::function<void(const tf2_msgs::TFMessage &)> hear = [this, are_static](const auto & message) {
    for (const auto & transform : message.transforms) {
      transforms_.setTransform(transform, "/tf", are_static);
    }
  };
  return node_.subscribe<tf2_msgs::TFMessage>(topic, kNoLimit, hear, ros::VoidConstPtr(), kNoDelay);
}

void LidarInputs::hear(const sensor_msgs::LaserScan::ConstPtr & scan) const
{
  if (scan->header.stamp > start_) {
    on_scan_(scan);
  }
}

bool LidarInputs::areConnected()
{
  if (scans_.getNumPublishers() == 0) {
    connected_since_.reset();
  } else if (!connected_since_) {
    connected_since_ = ros::WallTime::now();
  }
  return connected_since_ && ros::WallTime::now() - *connected_since_ >= kSettling;
}

bool LidarInputs::jumpsBackTo(const ros::Time & now)
{
  const bool jumps = now_ && now < *now_;
  now_ = now;
  return jumps;
}
}  // namespace workspace_support
