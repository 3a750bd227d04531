#include "throttled.h"

namespace move_base
{
bool Throttled::due(const ros::Time & stamp)
{
  const bool waiting = last && stamp >= *last && (stamp - *last).toSec() * frequency < 1.0;
  if (frequency <= 0.0 || waiting || publisher.getNumSubscribers() == 0) {
    return false;
  }
  last = stamp;
  return true;
}
}  // namespace move_base
