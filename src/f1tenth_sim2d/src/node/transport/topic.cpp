#include "node/transport/topic.h"

#include <ros/topic_manager.h>

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <utility>

namespace f1tenth_sim2d
{
Topic::Topic(ros::NodeHandle node, ros::AdvertiseOptions options, std::shared_ptr<TopicCounts> counts)
: name_(options.topic), counts_(std::move(counts))
{
  options.queue_size = kQueueSize;
  options.connect_cb = [this](const ros::SingleSubscriberPublisher & link) {
    subscribers_.insert(link.getSubscriberName());
  };
  options.disconnect_cb = [this](const ros::SingleSubscriberPublisher & link) {
    if (const auto found = subscribers_.find(link.getSubscriberName()); found != subscribers_.end()) {
      subscribers_.erase(found);
    }
  };
  publisher_ = node.advertise(options);
}

void Topic::publish(const ros::SerializedMessage & message)
{
  ++counts_->published;
  if (!hasSubscribers()) {
    return;
  }
  forgetWritten();
  counts_->lost += in_flight_.size() > kQueueSize ? 1 : 0;
  // Serialised already, so that roscpp shares its buffer with us; Publisher::publish() would do it once more.
  ros::SerializedMessage sent;
  ros::TopicManager::instance()->publish(
    publisher_.getTopic(), [&message] { return message; }, sent);
  in_flight_.push_back(message.buf);
}

void Topic::forgetWritten()
{
  const auto isWritten = [](const Buffer & buffer) { return holders(buffer) == 0; };
  in_flight_.erase(std::remove_if(in_flight_.begin(), in_flight_.end(), isWritten), in_flight_.end());
  given_up_ = in_flight_.empty() ? 0 : std::min(given_up_, holders(in_flight_.front()));
}

std::size_t Topic::inFlight()
{
  forgetWritten();
  return static_cast<std::size_t>(std::count_if(
    in_flight_.begin(), in_flight_.end(), [this](const Buffer & buffer) { return holders(buffer) > given_up_; }));
}

void Topic::giveUpThoseBehind()
{
  given_up_ = in_flight_.empty() ? 0 : holders(in_flight_.front());
}

std::string Topic::thoseBehind() const
{
  const bool all = !in_flight_.empty() && holders(in_flight_.front()) >= static_cast<long>(subscribers_.size());
  return (all ? "" : "one of ") + boost::algorithm::join(subscribers_, ", ");
}
}  // namespace f1tenth_sim2d
