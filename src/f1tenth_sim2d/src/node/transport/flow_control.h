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
/// Keeps the simulation from running away from its subscribers. It waits while somebody has too much left to read, and
/// names it. A subscriber that reads nothing at all for long is named and no longer waited for until it has caught
/// up, so that nobody can hang a run.
class FlowControl
{
public:
  /// @param queue                  served while waiting
  /// @param silent_subscriber_sec  wall s after which a subscriber that reads nothing at all is given up
  FlowControl(Outbox & outbox, ros::CallbackQueue & queue, double silent_subscriber_sec);

  /// Whether the simulation waits for slow subscribers, or lets them lose messages.
  void setWaiting(bool wait) { waits_ = wait; }

  /// Returns when everybody keeps up, or interrupted() is true.
  void waitForSubscribers(const std::function<bool()> & interrupted);
  /// Waits until everything published has been written to the subscribers' sockets, at most 2 s.
  void drain();

  /// Wall s spent waiting so far.
  double waitedSec() const { return waited_sec_; }
  /// Names of those that were waited for, given up or lost messages, each with its topic, since the previous call.
  std::set<std::string> takeSlowSubscribers();
  /// Messages that were lost so far because a subscriber lagged behind; if the simulation waits, only by those
  /// given up.
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
  const double silent_subscriber_sec_;
  bool waits_{true};
  std::map<std::string, Progress> progress_;     // by topic, while it lags behind
  std::map<std::string, std::uint64_t> losses_;  // by topic, as far as they have been noted
  std::map<std::string, ros::WallTime> said_;    // by topic, when a reader that does not keep up was last named
  std::set<std::string> slow_;
  double waited_sec_{0.0};
};
}  // namespace f1tenth_sim2d
