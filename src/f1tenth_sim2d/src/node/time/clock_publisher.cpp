#include "node/time/clock_publisher.h"

#include "node/messages/output.h"

namespace f1tenth_sim2d
{
ClockPublisher::ClockPublisher(Advertiser & advertiser, const ros::NodeHandle & node)
: publisher_(advertiser.advertise<rosgraph_msgs::Clock>(node, "/clock"))
{
}

void ClockPublisher::publish(SimTime now)
{
  rosgraph_msgs::Clock message;
  message.clock = toRosTime(now);
  publisher_.publish(message);
}
}  // namespace f1tenth_sim2d
