#include "plan_publisher.h"

#include <algorithm>
#include <set>

namespace move_base
{
PlanPublisher::PlanPublisher(ros::NodeHandle & node, const std::vector<std::string> & topics)
{
  std::set<std::string> resolved;
  for (const std::string & topic : topics) {
    if (resolved.insert(node.resolveName(topic)).second) {
      publishers_.push_back(node.advertise<nav_msgs::Path>(topic, 1));
    }
  }
}

bool PlanPublisher::wanted() const
{
  return std::any_of(publishers_.begin(), publishers_.end(), [](auto & each) { return each.getNumSubscribers() > 0; });
}

void PlanPublisher::publish(const nav_msgs::Path & plan) const
{
  for (const ros::Publisher & publisher : publishers_) {
    publisher.publish(plan);
  }
}
}  // namespace move_base
