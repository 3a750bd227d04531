// NavigationMgr in a C++ program: navigation_mgr_program ROBOT GOALS_FILE
#include "f1tenth_navigation_mgr/navigation_mgr.h"

#include <ros/ros.h>

#include <iostream>

using namespace f1tenth_navigation_mgr;

namespace
{
void drive(NavigationMgr & navmgr, const std::string & goals)
{
  navmgr.LoadGoals(goals);
  navmgr.OnGoalReached(
    [](const GoalResult & result) { std::cout << result.goal.x << " reached: " << result.text << std::endl; });
  navmgr.OnGoalFailed(
    [](const GoalResult & result) { std::cout << result.goal.x << " failed: " << result.text << std::endl; });
  while (ros::ok() && navmgr.Spin() != SpinResult::kQueueEmpty) {
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "program", ros::init_options::AnonymousName);
  NavigationMgr navmgr{argv[1]};
  try {
    drive(navmgr, argv[2]);
  } catch (const Error & error) {
    std::cout << error.what() << std::endl;
    return 2;
  }
}
