#pragma once

#include <ros/time.h>

#include <string>

#include "f1tenth_navigation_mgr/goal.h"

namespace f1tenth_navigation_mgr
{
/// How a goal ended.
enum class GoalOutcome
{
  kSucceeded,  ///< reached
  kAborted,    ///< the planner gave up
  kRejected,   ///< the planner did not take the goal
  kPreempted,  ///< cancelled, by us or by another client's goal
  kLost,       ///< the planner died, forgot the goal, fell silent or never acknowledged it
};

struct GoalResult
{
  Goal goal;
  GoalOutcome outcome{GoalOutcome::kLost};
  std::string text;  ///< the planner's message; for kLost: what was missing
  ros::Time sent;    ///< ROS time
  ros::Time ended;   ///< ROS time at which the client learned of it
};
}  // namespace f1tenth_navigation_mgr
