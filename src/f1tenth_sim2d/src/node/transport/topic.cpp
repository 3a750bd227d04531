#include "node/transport/topic.h"

#include <ros/topic_manager.h>

#include <algorithm>
#include <cstring>

namespace f1tenth_sim2d
{
namespace
{
constexpr std::size_t kLengthBytes = sizeof(std::uint32_t);
// More would only wait in memory: enough for the buffers that are usually under way at the same time.
constexpr std::size_t kFreeBuffers = 8;
constexpr std::size_t kLeastCapacity = 512;

template <class Integer>
void write(std::uint8_t * place, Integer value)
{
  const auto number = static_cast<std::uint32_t>(value);
  std::memcpy(place, &number, sizeof number);
}

std::uint32_t lengthAt(const std::uint8_t * place)
{
  std::uint32_t length = 0;
  std::memcpy(&length, place, sizeof length);
  return length;
}

ros::Publisher advertise(ros::NodeHandle & node, ros::AdvertiseOptions options)
{
  options.queue_size = Topic::kQueueSize;
  // roscpp would number buffers, not messages.
  options.has_header = false;
  return node.advertise(options);
}
}  // namespace

Topic::Topic(ros::NodeHandle node, const ros::AdvertiseOptions & options)
: publisher_(advertise(node, options)),
  publication_(ros::TopicManager::instance()->lookupPublication(publisher_.getTopic())),
  has_header_(options.has_header)
{
}

std::uint8_t * Topic::reserve(std::uint32_t length)
{
  begun_ = pending_.size();
  pending_.resize(begun_ + kLengthBytes + length);
  write(&pending_[begun_], length);
  return &pending_[begun_ + kLengthBytes];
}

void Topic::commit()
{
  if (has_header_) {
    // std_msgs/Header comes first in a message, and seq first in it.
    write(&pending_[begun_ + kLengthBytes], published_);
  }
  ++published_;
  ++pending_messages_;
}

bool Topic::flush(bool direct)
{
  const bool is_left_to_roscpp = !pending_.empty() && hasSubscribers() && !(direct && sendDirectly());
  if (is_left_to_roscpp) {
    handOver();
  }
  pending_.clear();
  pending_messages_ = 0;
  return is_left_to_roscpp;
}

bool Topic::sendDirectly()
{
  if (inFlight() > 0) {
    return false;
  }
  // Another publisher of the topic in this process: what roscpp has to write for it cannot be known.
  is_shared_ = is_shared_ || publication_->getNumCallbacks() > 1;
  if (
    is_shared_ || direct_sender_.isOutdated(*publication_) || !direct_sender_.send(pending_.data(), pending_.size())) {
    return false;
  }
  ++released_;
  return true;
}

void Topic::handOver()
{
  if (direct_sender_.isOutdated(*publication_)) {
    direct_sender_.lookAt(*publication_);
  }
  if (direct_sender_.allReadStreams()) {
    handOver(0, pending_.size(), pending_messages_);
    return;
  }
  for (std::size_t begin = 0; begin < pending_.size();) {
    const std::size_t size = kLengthBytes + lengthAt(&pending_[begin]);
    handOver(begin, size, 1);
    begin += size;
  }
}

void Topic::handOver(std::size_t begin, std::size_t size, std::uint64_t messages)
{
  if (inFlight() >= kQueueSize) {
    lost_ += messages;
  }
  const Buffer buffer = freeBuffer(size);
  std::copy_n(&pending_[begin], size, buffer.bytes.get());
  ros::SerializedMessage message(buffer.bytes, size);
  message.message_start = buffer.bytes.get() + kLengthBytes;
  publication_->publish(message);
  in_flight_.push_back(buffer);
}

std::size_t Topic::inFlight()
{
  // One holder each in in_flight_; roscpp holds the others.
  while (!in_flight_.empty() && in_flight_.front().bytes.use_count() == 1) {
    if (free_.size() < kFreeBuffers) {
      free_.push_back(in_flight_.front());
    }
    in_flight_.pop_front();
    ++released_;
  }
  return in_flight_.size();
}

Topic::Buffer Topic::freeBuffer(std::size_t size)
{
  while (!free_.empty()) {
    Buffer buffer = free_.back();
    free_.pop_back();
    if (buffer.capacity >= size) {
      return buffer;
    }
  }
  const std::size_t capacity = std::max(size, kLeastCapacity);
  return {boost::shared_array<std::uint8_t>(new std::uint8_t[capacity]), capacity};
}
}  // namespace f1tenth_sim2d
