#include "node/transport/outbox.h"

#include <algorithm>

namespace f1tenth_sim2d
{
std::shared_ptr<MessageSink> Outbox::add(const ros::AdvertiseOptions & options)
{
  const auto isGone = [](const std::weak_ptr<Topic> & topic) { return topic.expired(); };
  topics_.erase(std::remove_if(topics_.begin(), topics_.end(), isGone), topics_.end());
  auto & counts = counts_[options.topic];
  if (!counts) {
    counts = std::make_shared<TopicCounts>();
  }
  auto topic = std::make_shared<Topic>(node_, options, counts);
  topics_.push_back(topic);
  return topic;
}

// Asked in every period: as long as none is wanted, nothing is allocated.
template <typename Wanted>
std::vector<std::shared_ptr<Topic>> Outbox::those(Wanted wanted) const
{
  std::vector<std::shared_ptr<Topic>> result;
  for (const auto & each : topics_) {
    if (auto topic = each.lock(); topic && wanted(*topic)) {
      result.push_back(std::move(topic));
    }
  }
  return result;
}

std::size_t Outbox::subscriberCount() const
{
  std::size_t count = 0;
  for (const auto & topic : those([](Topic &) { return true; })) {
    count += topic->subscriberCount();
  }
  return count;
}

std::vector<std::shared_ptr<Topic>> Outbox::lagging(std::size_t limit) const
{
  return those([limit](Topic & topic) { return topic.inFlight() > limit; });
}
}  // namespace f1tenth_sim2d
