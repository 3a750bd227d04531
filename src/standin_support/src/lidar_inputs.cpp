#include "standin_support/lidar_inputs.h"

namespace standin_support
{
namespace
{
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();
}  // namespace

ros::NodeHandle servedBy(ros::CallbackQueue & queue)
{
  ros::NodeHandle node;
  node.setCallbackQueue(&queue);
  return node;
}

LidarInputs::LidarInputs(ros::CallbackQueue & queue, tf2::BufferCore & transforms, const OnScan & on_scan)
: node_(servedBy(queue)), listener_(transforms, node_, false, kNoDelay)
{
  // Without a limit: what is waiting in lockstep must not be lost, and scans are left out only for want of time.
  subscriber_ = node_.subscribe<sensor_msgs::LaserScan>("scan", 0, on_scan, ros::VoidConstPtr(), kNoDelay);
}

bool LidarInputs::jumpsBackTo(const ros::Time & now)
{
  const bool jumps = now_ && now < *now_;
  now_ = now;
  return jumps;
}
}  // namespace standin_support
