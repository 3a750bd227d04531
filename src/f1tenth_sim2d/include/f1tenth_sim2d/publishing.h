#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <cstdint>
#include <string>

/// How the simulator and its plugins publish.
namespace f1tenth_sim2d
{
/// Makes the topics of the simulator.
class Advertiser
{
public:
  /// Messages that are kept for a subscriber that does not keep up: some minutes of a sensor. Beyond, it loses the
  /// oldest.
  static constexpr std::uint32_t kQueueSize = 10'000;

  /// @param topic  in the namespace of node, unless it is absolute
  template <class Message>
  ros::Publisher advertise(ros::NodeHandle node, const std::string & topic)
  {
    return node.advertise<Message>(topic, kQueueSize, [this](const ros::SingleSubscriberPublisher &) { ++arrivals_; });
  }

  /// Subscribers that have come so far, to any topic.
  std::uint64_t arrivals() const { return arrivals_; }

private:
  std::uint64_t arrivals_{0};
};

/// Publishes on /tf. All transforms of one simulated time leave in one message.
class TransformSender
{
public:
  virtual ~TransformSender() = default;
  virtual void send(const geometry_msgs::TransformStamped & transform) = 0;
};
}  // namespace f1tenth_sim2d
