#pragma once

#include <ros/node_handle.h>

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "faulty_line.h"

namespace f1tenth_scenarios
{
/// One input of a planner, passed on over a faulty line.
class Relay
{
public:
  virtual ~Relay() = default;
  /// Passes on what is due at now, what has arrived since the last call included.
  virtual void passOn(const ros::Time & now) = 0;
};

template <class Message>
class TopicRelay : public Relay
{
public:
  TopicRelay(ros::NodeHandle & node, const std::string & from, const std::string & to, std::vector<InputFault> faults)
  : line_(std::move(faults)),
    publisher_(
      node.advertise<Message>(to, kQueueSize, [this](const ros::SingleSubscriberPublisher & late) { repeat(late); })),
    subscriber_(node.subscribe(from, kQueueSize, &TopicRelay::onMessage, this, ros::TransportHints().tcpNoDelay()))
  {
  }

  void passOn(const ros::Time & now) override
  {
    for (Pointer & message : arrived_) {
      line_.take(now.toSec(), std::move(message));
    }
    arrived_.clear();
    for (const Pointer & message : line_.release(now.toSec())) {
      publisher_.publish(message);
      recent_.push_back(message);
    }
    while (recent_.size() > kRecent) {
      recent_.pop_front();
    }
  }

private:
  using Pointer = typename Message::ConstPtr;
  static constexpr std::uint32_t kQueueSize = 1000;
  // More than a period's transforms: the planner may connect after the first period was published.
  static constexpr std::size_t kRecent = 20;

  void onMessage(const Pointer & message) { arrived_.push_back(message); }
  void repeat(const ros::SingleSubscriberPublisher & late)
  {
    for (const Pointer & message : recent_) {
      late.publish(*message);
    }
  }

  FaultyLine<Pointer> line_;
  std::vector<Pointer> arrived_;
  std::deque<Pointer> recent_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};
}  // namespace f1tenth_scenarios
