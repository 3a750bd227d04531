#pragma once

#include <nav_msgs/Path.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

namespace move_base
{
/// Publishes plans on several topics, as the originals' planners have names of their own.
class PlanPublisher
{
public:
  /// @param topics  names that are remapped to one topic count once
  PlanPublisher(ros::NodeHandle & node, const std::vector<std::string> & topics);

  bool wanted() const;
  void publish(const nav_msgs::Path & plan) const;

private:
  std::vector<ros::Publisher> publishers_;
};
}  // namespace move_base
