#pragma once

#include <ros/node_handle.h>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// Publishes simulated time on /clock.
class ClockPublisher
{
public:
  explicit ClockPublisher(ros::NodeHandle & node);
  void publish(SimTime now);

private:
  ros::Publisher publisher_;
};
}  // namespace f1tenth_sim2d
