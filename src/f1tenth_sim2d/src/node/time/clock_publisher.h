#pragma once

#include <ros/node_handle.h>
#include <rosgraph_msgs/Clock.h>

#include "f1tenth_sim2d/publishing.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// Publishes simulated time on /clock.
class ClockPublisher
{
public:
  ClockPublisher(Advertiser & advertiser, const ros::NodeHandle & node);
  void publish(SimTime now);

private:
  TopicPublisher<rosgraph_msgs::Clock> publisher_;
};
}  // namespace f1tenth_sim2d
