#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_msgs/UInt32.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "sim2d_lockstep/participant.h"

namespace
{
constexpr int kTopics = 20;
constexpr std::uint32_t kPeriods = 3000;

/// Keeps all cores busy, so that threads are interrupted where it hurts.
class Load
{
public:
  Load()
  {
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) {
      threads_.emplace_back([this] {
        while (!stop_) {
        }
      });
    }
  }
  ~Load()
  {
    stop_ = true;
    for (auto & thread : threads_) {
      thread.join();
    }
  }

private:
  std::atomic<bool> stop_{false};
  std::vector<std::thread> threads_;
};
}  // namespace

TEST(InboxDrain, WhatWasSentBeforeTheClockIsThereWhenTheParticipantActs)
{
  ros::NodeHandle node;
  std::vector<std::uint32_t> numbers(kTopics, 0);
  std::vector<ros::Subscriber> subscribers;
  subscribers.reserve(kTopics);
  for (int i = 0; i < kTopics; ++i) {
    subscribers.push_back(node.subscribe<std_msgs::UInt32>(
      "topic" + std::to_string(i), 0,
      [&numbers, i](const std_msgs::UInt32::ConstPtr & message) { numbers[i] = message->data; }));
  }
  sim2d_lockstep::Participant participant("listener");
  const Load load;
  for (std::uint32_t period = 1; period <= kPeriods; ++period) {
    const auto stamp = participant.waitForPeriod(ros::WallDuration(20.0));
    ASSERT_TRUE(stamp) << "period " << period;
    ros::getGlobalCallbackQueue()->callAvailable();
    ASSERT_EQ(numbers, std::vector<std::uint32_t>(kTopics, period));
    participant.done(*stamp);
  }
}

TEST(InboxDrain, ReturnsAfterShutdown)
{
  sim2d_lockstep::InboxDrain drain;
  drain.drain();
  ros::shutdown();
  drain.drain();
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "inbox_drain_test");
  testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
