#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <functional>
#include <optional>
#include <string>

namespace workspace_support
{
/// A handle whose subscriptions and services are served by this queue.
ros::NodeHandle servedBy(ros::CallbackQueue & queue);

/// Inputs of a lidar node, on one queue: scans, transforms, and what else is subscribed to by servedBy(queue).
class LidarInputs
{
public:
  using OnScan = std::function<void(const sensor_msgs::LaserScan::ConstPtr &)>;

  /// @param transforms  is filled with /tf and /tf_static
  LidarInputs(ros::CallbackQueue & queue, tf2::BufferCore & transforms, const OnScan & on_scan);

  /// Ignores scans up to then. In the period in which nodes connect, one may get the scan and another not.
  void startAfter(const ros::Time & stamp) { start_ = stamp; }
  /// Whether scans have been connected for long enough to get the next one: roscpp does not tell when the other end
  /// knows of a connection.
  bool areConnected();
  /// Whether ROS time has jumped back since the previous call.
  bool jumpsBackTo(const ros::Time & now);

private:
  void hear(const sensor_msgs::LaserScan::ConstPtr & scan) const;
  ros::Subscriber subscribeToTransforms(const std::string & topic, bool are_static);

  ros::NodeHandle node_;
  tf2::BufferCore & transforms_;
  OnScan on_scan_;
  ros::Subscriber moving_transforms_;
  ros::Subscriber static_transforms_;
  ros::Subscriber scans_;
  ros::Time start_;
  std::optional<ros::WallTime> connected_since_;
  std::optional<ros::Time> now_;
};
}  // namespace workspace_support
