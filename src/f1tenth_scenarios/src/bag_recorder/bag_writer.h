#pragma once

#include <ros/node_handle.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace f1tenth_scenarios
{
constexpr std::uint64_t kMegabyte = 1U << 20;  // bytes

/// Writes what it hears on topics into a bag.
class BagWriter
{
public:
  /// How much of what a planner publishes may stand in a bag, bytes before compression.
  struct Limits
  {
    std::uint64_t topic;
    std::uint64_t all;
  };

  /// @throws rosbag::BagException the file cannot be written
  BagWriter(const std::string & file, const Limits & limits);

  /// Hears a topic until the end, however much is published.
  void record(const std::string & topic);

  /// Hears a topic until the limits are reached; one that is known already stays as it is.
  void recordWithinLimits(const std::string & topic);

  /// Completes the file.
  void close();

  /// The topics that reached a limit, and since when, one line each.
  [[nodiscard]] const std::vector<std::string> & dropped() const { return dropped_; }

private:
  using Event = ros::MessageEvent<const topic_tools::ShapeShifter>;
  struct Topic
  {
    ros::Subscriber subscriber;
    std::uint64_t size = 0;  // bytes so far
    ros::Time next;          // before which a picture is left out
  };

  void subscribe(const std::string & topic, bool is_limited);
  void take(const std::string & name, const Event & event, bool is_limited);
  bool isInTime(Topic & topic, const topic_tools::ShapeShifter & message, const ros::Time & now) const;
  bool hasRoom(const std::string & name, Topic & topic, std::uint64_t size, const ros::Time & now);

  rosbag::Bag bag_;
  Limits limits_;
  std::uint64_t size_ = 0;  // bytes so far of what is limited
  ros::NodeHandle node_;
  std::map<std::string, Topic> topics_;
  std::vector<std::string> dropped_;
};
}  // namespace f1tenth_scenarios
