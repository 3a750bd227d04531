#include "node/transport/outbox.h"

#include <ros/poll_manager.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/topic_manager.h>

#include <algorithm>

#include "node/transport/subscriber_connections.h"

namespace f1tenth_sim2d
{
std::shared_ptr<MessageSink> Outbox::add(const ros::AdvertiseOptions & options)
{
  ros::AdvertiseOptions complete = options;
  if (immediate_) {
    complete.connect_cb = [](const ros::SingleSubscriberPublisher & link) {
      if (const auto publication = ros::TopicManager::instance()->lookupPublication(link.getTopic())) {
        for (const auto & connection : connectionsOf(*publication)) {
          disableDelay(connection);
        }
      }
    };
  }
  auto topic = std::make_shared<Topic>(node_, complete);
  topics_.push_back(topic);
  return topic;
}

void Outbox::flush()
{
  bool is_left_to_roscpp = false;
  bool expired = false;
  for (const auto & each : topics_) {
    const auto topic = each.lock();
    expired = expired || !topic;
    is_left_to_roscpp = (topic && topic->flush(direct_)) || is_left_to_roscpp;
  }
  if (is_left_to_roscpp) {
    ros::PollManager::instance()->getPollSet().signal();
  }
  if (expired) {
    const auto end = std::remove_if(topics_.begin(), topics_.end(), [](const auto & each) { return each.expired(); });
    topics_.erase(end, topics_.end());
  }
}

std::vector<std::shared_ptr<Topic>> Outbox::topics() const
{
  std::vector<std::shared_ptr<Topic>> result;
  for (const auto & each : topics_) {
    if (auto topic = each.lock()) {
      result.push_back(std::move(topic));
    }
  }
  return result;
}

std::size_t Outbox::subscriberCount() const
{
  std::size_t count = 0;
  for (const auto & topic : topics()) {
    count += topic->publication().getNumSubscribers();
  }
  return count;
}

std::vector<std::shared_ptr<Topic>> Outbox::lagging(std::size_t limit)
{
  auto result = topics();
  const auto end =
    std::remove_if(result.begin(), result.end(), [&](const auto & topic) { return topic->inFlight() <= limit; });
  result.erase(end, result.end());
  return result;
}

bool Outbox::isLagging(std::size_t limit)
{
  return std::any_of(topics_.begin(), topics_.end(), [&](const auto & each) {
    const auto topic = each.lock();
    return topic && topic->inFlight() > limit;
  });
}
}  // namespace f1tenth_sim2d
