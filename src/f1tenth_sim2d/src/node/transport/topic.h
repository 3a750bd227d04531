#pragma once

#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "f1tenth_sim2d/publishing.h"

namespace f1tenth_sim2d
{
/// Messages of a topic, whoever publishes on it.
struct TopicCounts
{
  std::uint64_t published{0};
  std::uint64_t lost{0};  ///< that some subscriber has lost because it lagged behind
};

/// One topic over roscpp. The buffers that roscpp still holds tell how far subscribers lag behind: each holds on to
/// what has not been written to its socket yet.
class Topic : public MessageSink
{
public:
  /// Messages that roscpp keeps for a subscriber; beyond, that subscriber loses the oldest.
  static constexpr std::uint32_t kQueueSize = 256;

  /// @param node    whose callback queue tells of subscribers that come and go
  /// @param counts  to which it adds; several outputs may share a topic
  Topic(ros::NodeHandle node, ros::AdvertiseOptions options, std::shared_ptr<TopicCounts> counts);

  const std::string & name() const { return name_; }
  bool hasSubscribers() const override { return publisher_.getNumSubscribers() > 0; }
  void publish(const ros::SerializedMessage & message) override;

  /// Messages not yet sent to somebody who is waited for.
  std::size_t inFlight();
  /// From now on inFlight() is about the others only, until those who lag behind now have caught up or gone.
  void giveUpThoseBehind();
  /// Names of those who lag behind; roscpp tells how many these are, not which: "one of /a, /b" if not all do.
  std::string thoseBehind() const;
  std::size_t subscriberCount() const { return publisher_.getNumSubscribers(); }
  /// Messages that some subscriber has lost because it lagged behind.
  std::uint64_t lost() const { return counts_->lost; }

private:
  using Buffer = boost::shared_array<std::uint8_t>;

  void forgetWritten();
  /// Number of subscribers to which a message has not been sent yet; the newer ones have not either.
  static long holders(const Buffer & buffer) { return buffer.use_count() - 1; }

  const std::string name_;
  std::multiset<std::string> subscribers_;  // before the publisher, whose callbacks fill it
  ros::Publisher publisher_;
  std::vector<Buffer> in_flight_;  // oldest first
  long given_up_{0};               // how many subscribers are not waited for
  const std::shared_ptr<TopicCounts> counts_;
};
}  // namespace f1tenth_sim2d
