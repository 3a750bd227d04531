#include "f1tenth_navigation_mgr/start_signal.h"

#include <ros/node_handle.h>

#include <utility>

namespace f1tenth_navigation_mgr
{
StartSignal::StartSignal(const std::string & topic, std::string starter) : starter_(std::move(starter))
{
  using Event = ros::MessageEvent<const std_msgs::Int32>;
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const Event &>(topic, 10, [this](const Event & event) { take(event); });
  options.callback_queue = &queue_;
  // In lockstep two announcements may follow each other within the 40 ms for which TCP holds small messages back.
  options.transport_hints.tcpNoDelay();
  subscriber_ = ros::NodeHandle{}.subscribe(options);
}

void StartSignal::take(const ros::MessageEvent<const std_msgs::Int32> & event)
{
  if (!starter_.empty() && event.getPublisherName() != starter_) {
    return;
  }
  seconds_left_ = event.getConstMessage()->data;
  started_ = started_ || seconds_left_ <= 0;
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
