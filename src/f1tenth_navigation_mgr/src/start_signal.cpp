#include "f1tenth_navigation_mgr/start_signal.h"

#include <ros/node_handle.h>

namespace f1tenth_navigation_mgr
{
StartSignal::StartSignal(const std::string & topic)
{
  auto options = ros::SubscribeOptions::create<std_msgs::Int32>(
    topic, 10,
    [this](const std_msgs::Int32::ConstPtr & message) {
      seconds_left_ = message->data;
      started_ = started_ || message->data <= 0;
    },
    ros::VoidPtr{}, &queue_);
  // In lockstep two announcements may follow each other within the 40 ms for which TCP holds small messages back.
  options.transport_hints.tcpNoDelay();
  subscriber_ = ros::NodeHandle{}.subscribe(options);
}

std::optional<std::int32_t> StartSignal::SecondsLeft()
{
  queue_.callAvailable();
  return seconds_left_;
}

bool StartSignal::HasStarted()
{
  queue_.callAvailable();
  return started_;
}
}  // namespace f1tenth_navigation_mgr
