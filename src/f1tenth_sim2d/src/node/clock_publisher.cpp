#include "clock_publisher.h"

#include <rosgraph_msgs/Clock.h>

#include "output.h"

namespace f1tenth_sim2d
{
namespace
{
// For somebody who lags behind, an old time is worth nothing.
constexpr std::uint32_t kQueueSize = 10;
}  // namespace

ClockPublisher::ClockPublisher(ros::NodeHandle & node)
: publisher_(node.advertise<rosgraph_msgs::Clock>("/clock", kQueueSize))
{
}

void ClockPublisher::publish(SimTime now)
{
  rosgraph_msgs::Clock message;
  message.clock = toRosTime(now);
  publisher_.publish(message);
}
}  // namespace f1tenth_sim2d
