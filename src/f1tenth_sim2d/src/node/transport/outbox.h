#pragma once

#include <ros/node_handle.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "node/transport/topic.h"

namespace f1tenth_sim2d
{
/// All topics of the simulator.
class Outbox : public Advertiser
{
public:
  /// @param node  its callback queue must be served by the simulation's thread
  explicit Outbox(const ros::NodeHandle & node) : node_(node) {}

  /// The topics of which more than `limit` messages wait for a subscriber.
  std::vector<std::shared_ptr<Topic>> lagging(std::size_t limit) const;
  /// What was published and lost, by topic; also of topics that no longer have a publisher.
  const std::map<std::string, std::shared_ptr<TopicCounts>> & counts() const { return counts_; }
  /// Subscribers of all topics together.
  std::size_t subscriberCount() const;

protected:
  std::shared_ptr<MessageSink> add(const ros::AdvertiseOptions & options) override;

private:
  template <typename Wanted>
  std::vector<std::shared_ptr<Topic>> those(Wanted wanted) const;

  const ros::NodeHandle node_;
  std::vector<std::weak_ptr<Topic>> topics_;
  std::map<std::string, std::shared_ptr<TopicCounts>> counts_;
};
}  // namespace f1tenth_sim2d
