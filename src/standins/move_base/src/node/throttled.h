#pragma once

#include <ros/publisher.h>
#include <ros/time.h>

#include <optional>

namespace move_base
{
/// A topic that is published at most at a given rate, and only for subscribers.
struct Throttled
{
  ros::Publisher publisher;
  double frequency;  ///< Hz; 0: never
  std::optional<ros::Time> last;

  bool due(const ros::Time & stamp)
  {
    const bool waiting = last && stamp >= *last && (stamp - *last).toSec() * frequency < 1.0;
    if (frequency <= 0.0 || waiting || publisher.getNumSubscribers() == 0) {
      return false;
    }
    last = stamp;
    return true;
  }
};
}  // namespace move_base
