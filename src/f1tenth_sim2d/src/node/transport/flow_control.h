#pragma once

#include <ros/callback_queue.h>

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "node/transport/outbox.h"

namespace f1tenth_sim2d
{
/// What to do with subscribers that do not keep up.
struct FlowOptions
{
  bool wait{true};                     ///< whether the simulation waits for them
  double silent_subscriber_sec{10.0};  ///< wall s after which one that reads nothing at all is given up
};

/// Keeps the simulation from running away from its subscribers. It waits while somebody has too much left to read, and
/// says who it is. A subscriber that reads nothing at all for long is named and no longer waited for until it has caught
/// up, so that nobody can hang a run.
class FlowControl
{
public:
  /// @param queue  served while waiting
  FlowControl(Outbox & outbox, ros::CallbackQueue & queue, FlowOptions options);

  /// Whether the simulation waits for slow subscribers, or lets them lose messages.
  void setWaiting(bool wait) { options_.wait = wait; }

  /// Returns when everybody keeps up, or interrupted() is true.
  void waitForSubscribers(const std::function<bool()> & interrupted);
  /// Waits until everything published has been written to the subscribers' sockets, at most 2 s.
  void drain();

  /// Wall s spent waiting so far.
  double waitedSec() const { return waited_sec_; }
  /// Names of those that were waited for, given up or lost messages, each with its topic, since the call before.
  std::set<std::string> takeSlowSubscribers();
  /// Messages that were lost so far because a subscriber lagged behind; if the simulation waits, only by those given up.
  std::uint64_t lostMessages() const;

private:
  struct Progress
  {
    std::size_t in_flight;
    ros::WallTime since;
  };

  void waitUntilBelow(std::size_t limit, const std::function<bool()> & interrupted);
  void giveUp(Topic & topic);
  void noteLosses();
  void note(const Topic & topic);

  Outbox & outbox_;
  ros::CallbackQueue & queue_;
  FlowOptions options_;
  std::map<std::string, Progress> progress_;     // by topic, while it lags behind
  std::map<std::string, std::uint64_t> losses_;  // by topic, as far as they have been noted
  std::set<std::string> slow_;
  double waited_sec_{0.0};
};
}  // namespace f1tenth_sim2d
