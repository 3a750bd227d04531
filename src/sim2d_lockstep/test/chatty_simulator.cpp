// Plays a simulator that sends a number over many topics and then the period's /clock, for inbox_drain_test.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Header.h>
#include <std_msgs/UInt32.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim2d_lockstep/participant.h"

namespace
{
constexpr int kTopics = 20;
constexpr std::uint64_t kPeriod = 25000000;  // ns
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "chatty_simulator");
  ros::NodeHandle node;
  sim2d_lockstep::InboxDrain drain;
  ros::Time answered;
  const auto done = node.subscribe<std_msgs::Header>(
    "/sim2d/done", 0, [&](const std_msgs::Header::ConstPtr & message) { answered = message->stamp; },
    ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  // Advertised first, so that roscpp would send it first if it were left to roscpp.
  auto clock = node.advertise<rosgraph_msgs::Clock>("/clock", 10);
  std::vector<ros::Publisher> topics;
  topics.reserve(kTopics);
  for (int i = 0; i < kTopics; ++i) {
    topics.push_back(node.advertise<std_msgs::UInt32>("topic" + std::to_string(i), 10));
  }
  const auto connected = [&] {
    return clock.getNumSubscribers() > 0 && done.getNumPublishers() > 0 &&
           std::all_of(topics.begin(), topics.end(), [](auto & topic) { return topic.getNumSubscribers() > 0; });
  };
  while (ros::ok() && !connected()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }

  for (std::uint32_t period = 1; ros::ok(); ++period) {
    std_msgs::UInt32 number;
    number.data = period;
    for (auto & topic : topics) {
      topic.publish(number);
    }
    drain.drain();
    rosgraph_msgs::Clock message;
    message.clock.fromNSec(kPeriod * period);
    clock.publish(message);
    while (ros::ok() && answered < message.clock) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
    }
  }
}
