#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <string>

#include "throttled.h"

namespace move_base
{
/// A costmap that is shown as the original shows it: whole on COSTMAP/costmap for a new subscriber and whenever it lies elsewhere
/// or has another size, else the rectangle in which it has changed on COSTMAP/costmap_updates; and the car's outline on
/// COSTMAP/footprint.
class CostmapPublisher
{
public:
  /// @param costmap       namespace of the topics
  /// @param frequency     Hz; 0: the costmap only for new subscribers, the outline never
  /// @param always_whole  even if only a part has changed
  /// Subscribers are noticed on the queue of node. Keeps its place in memory.
  CostmapPublisher(ros::NodeHandle & node, const std::string & costmap, double frequency, bool always_whole);
  CostmapPublisher(const CostmapPublisher &) = delete;
  CostmapPublisher & operator=(const CostmapPublisher &) = delete;

  bool due(const ros::Time & stamp)
  {
    return whole_.due(stamp) || (newcomer_ && whole_.publisher.getNumSubscribers() > 0);
  }
  void publish(nav_msgs::OccupancyGrid costs);
  Throttled & footprint() { return footprint_; }

private:
  bool always_whole_;
  bool newcomer_{false};           // somebody who has seen nothing yet
  nav_msgs::OccupancyGrid shown_;  // what subscribers have
  Throttled whole_;
  ros::Publisher updates_;
  Throttled footprint_;
};
}  // namespace move_base
