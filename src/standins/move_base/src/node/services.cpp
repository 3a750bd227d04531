#include "services.h"

#include <ros/console.h>

#include "conversions.h"
#include "planning/plan_near.h"

namespace move_base
{
namespace
{
constexpr double kElsewhere = 0.01;  // m from the goal, the plan ends at another place
}

Services::Services(
  ros::NodeHandle private_node, const MoveBaseParameters & parameters, Perception & perception,
  const Navigator & navigator)
: parameters_(parameters),
  perception_(perception),
  navigator_(navigator),
  make_plan_(private_node.advertiseService("make_plan", &Services::makePlan, this)),
  planner_make_plan_(
    private_node.advertiseService(parameters.global_planner + "/make_plan", &Services::makePlan, this)),
  clear_costmaps_(private_node.advertiseService("clear_costmaps", &Services::clearCostmaps, this))
{
}

bool Services::makePlan(nav_msgs::GetPlan::Request & request, nav_msgs::GetPlan::Response & response)
{
  if (navigator_.drives() || !perception_.ready()) {
    ROS_ERROR(
      "make_plan: %s", navigator_.drives() ? "must not be called while the car drives"
                                           : ("still waits for " + perception_.missing()).c_str());
    return false;
  }
  try {
    response.plan = toPath(planFor(request), headerOf(parameters_.global_frame, ros::Time::now()));
    return true;
  } catch (const tf2::TransformException & error) {
    ROS_ERROR("make_plan: %s", error.what());
    return false;
  }
}

std::vector<Pose2> Services::planFor(const nav_msgs::GetPlan::Request & request) const
{
  const bool from_car = request.start.header.frame_id.empty();
  const Pose2 start =
    from_car ? perception_.poseIn(parameters_.global_frame, parameters_.base_frame) : perception_.inMap(request.start);
  const Pose2 goal = perception_.inMap(request.goal);
  PlanRequest wanted{start, goal};
  wanted.max_expansions = parameters_.max_expansions;
  const Plan plan = planNear(navigator_.globalPlanner(), perception_.costmap(), wanted, request.tolerance);
  std::vector<Pose2> poses = posesOf(plan.path);
  // As in the original: whoever drives along the plan may get there after all.
  if (plan.found() && distance(plan.path.back().pose, goal) > kElsewhere) {
    poses.push_back(goal);
  }
  return poses;
}

bool Services::clearCostmaps(std_srvs::Empty::Request &, std_srvs::Empty::Response &)
{
  if (perception_.ready()) {
    perception_.costmap().forgetAll();
  }
  return true;
}
}  // namespace move_base
