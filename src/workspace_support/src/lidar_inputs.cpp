#include "workspace_support/lidar_inputs.h"

namespace workspace_support
{
namespace
{
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();
const ros::WallDuration kSettling{0.1};
}  // namespace

ros::NodeHandle servedBy(ros::CallbackQueue & queue)
{
  ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  return node;
}

LidarInputs::LidarInputs(ros::CallbackQueue & queue, tf2::BufferCore & transforms, const OnScan & on_scan)
: node_(servedBy(queue)), on_scan_(on_scan), listener_(transforms, node_, false, kNoDelay)
{
  // Without a limit: what is waiting in lockstep must not be lost, and scans are left out only for want of time.
  subscriber_ = node_.subscribe("scan", 0, &LidarInputs::hear, this, kNoDelay);
}

void LidarInputs::hear(const sensor_msgs::LaserScan::ConstPtr & scan) const
{
  if (scan->header.stamp > start_) {
    on_scan_(scan);
  }
}

bool LidarInputs::areConnected()
{
  if (subscriber_.getNumPublishers() == 0) {
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
