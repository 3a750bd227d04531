#pragma once

#include <ros/publication.h>
#include <ros/publisher.h>
#include <ros/serialized_message.h>

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "f1tenth_sim2d/publishing.h"
#include "node/transport/direct_sender.h"

namespace f1tenth_sim2d
{
/// One topic over roscpp. Messages collect until flush() sends them together, in a buffer that each subscriber gets as
/// it stands: message after message, each behind its length, is what TCPROS is. Buffers are used again when roscpp has let go of
/// them; those that it still holds tell how far the slowest subscriber lags behind.
class Topic : public MessageSink
{
public:
  /// What roscpp keeps for a subscriber, in buffers; beyond, that subscriber loses the oldest.
  static constexpr std::uint32_t kQueueSize = 256;

  /// @param node  whose callback queue gets the connection callbacks of options
  Topic(ros::NodeHandle node, const ros::AdvertiseOptions & options);

  const std::string & name() const { return publication_->getName(); }
  bool hasSubscribers() const override { return publication_->hasSubscribers(); }
  std::uint8_t * reserve(std::uint32_t length) override;
  void commit() override;

  /// Sends what has collected, or hands it over to roscpp.
  /// @param direct  whether to send on the calling thread if nothing is in the way
  /// @return whether roscpp's poll thread is still to be told
  bool flush(bool direct);
  /// Buffers that have not been written to all subscribers yet.
  std::size_t inFlight();
  /// How many buffers have been written to all subscribers (or given up) so far: grows as long as they read.
  std::uint64_t released() const { return released_; }
  /// Messages so far, whether or not anybody listened when they were handed over.
  std::uint64_t published() const { return published_; }
  /// Messages that some subscriber has lost because it lagged behind.
  std::uint64_t lost() const { return lost_; }
  ros::Publication & publication() const { return *publication_; }

private:
  struct Buffer
  {
    boost::shared_array<std::uint8_t> bytes;
    std::size_t capacity;
  };

  bool sendDirectly();
  void handOver();
  void handOver(std::size_t begin, std::size_t size, std::uint64_t messages);
  Buffer freeBuffer(std::size_t size);

  ros::Publisher publisher_;  // keeps the topic advertised
  ros::PublicationPtr publication_;
  DirectSender direct_sender_;
  bool is_shared_{false};  // with another publisher in this process
  const bool has_header_;
  std::vector<std::uint8_t> pending_;  // length and message, again and again
  std::size_t begun_{0};               // where the message reserved last begins in pending_
  std::uint64_t pending_messages_{0};
  std::deque<Buffer> in_flight_;  // oldest first
  std::vector<Buffer> free_;
  std::uint64_t released_{0};
  std::uint64_t published_{0};
  std::uint64_t lost_{0};
};
}  // namespace f1tenth_sim2d
