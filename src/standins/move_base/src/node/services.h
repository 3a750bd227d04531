#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/GetPlan.h>
#include <ros/node_handle.h>
#include <std_srvs/Empty.h>

#include <vector>

#include "move_base/control/navigator.h"
#include "parameters.h"
#include "perception.h"

namespace move_base
{
/// The services of the original: plans for somebody else, and forgetting what the lidar saw.
class Services
{
public:
  Services(
    ros::NodeHandle private_node, const MoveBaseParameters & parameters, Perception & perception,
    const Navigator & navigator);

private:
  bool makePlan(nav_msgs::GetPlan::Request & request, nav_msgs::GetPlan::Response & response);
  bool clearCostmaps(std_srvs::Empty::Request & request, std_srvs::Empty::Response & response);
  std::vector<Pose2> planFor(const nav_msgs::GetPlan::Request & request) const;

  const MoveBaseParameters & parameters_;
  Perception & perception_;
  const Navigator & navigator_;
  ros::ServiceServer make_plan_;
  ros::ServiceServer planner_make_plan_;
  ros::ServiceServer clear_costmaps_;
};
}  // namespace move_base
