#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "node/transport/topic.h"

namespace f1tenth_sim2d
{
/// All topics of the simulator.
class Outbox : public Advertiser
{
public:
  /// @param node       its callback queue must be served by the simulation's thread
  /// @param immediate  subscribers get small messages at once, whatever they asked for (see disableDelay)
  Outbox(ros::NodeHandle node, bool immediate) : node_(std::move(node)), immediate_(immediate) {}

  /// Whether flush() sends on the calling thread where it can. That is the least work; leaving it to roscpp's poll thread
  /// is more, but lets the simulation go on beside it.
  void setDirect(bool direct) { direct_ = direct; }
  /// Sends what has been published since, each topic's messages together.
  void flush();
  /// The topics of which more than `limit` buffers wait for a subscriber.
  std::vector<std::shared_ptr<Topic>> lagging(std::size_t limit);
  /// Whether there are any.
  bool isLagging(std::size_t limit);
  std::vector<std::shared_ptr<Topic>> topics() const;
  /// Subscribers of all topics together.
  std::size_t subscriberCount() const;

protected:
  std::shared_ptr<MessageSink> add(const ros::AdvertiseOptions & options) override;

private:
  const ros::NodeHandle node_;
  const bool immediate_;
  bool direct_{false};
  std::vector<std::weak_ptr<Topic>> topics_;
};
}  // namespace f1tenth_sim2d
