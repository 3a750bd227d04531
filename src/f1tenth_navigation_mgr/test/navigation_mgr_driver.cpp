// Drives the C++ class as navigation_mgr_driver.py drives the Python one; behaviour_test.py compares what they print.
//   navigation_mgr_test_driver ROBOT GOALS_FILE [loop|cancel|parts|add|drop]
#include <ros/ros.h>

#include <iostream>

#include "f1tenth_navigation_mgr/navigation_mgr.h"

using namespace f1tenth_navigation_mgr;

namespace
{
constexpr std::size_t kLoopedGoals{5};
constexpr int kSpinsAfterEnd{5};

void print(const GoalResult & result)
{
  std::cout << "goal " << result.goal.x << " " << ToString(result.outcome) << ": " << result.text << std::endl;
}

// The thesis's Spin, with its names.
SpinResult spinByParts(NavigationMgr & navmgr)
{
  if (navmgr.HasActiveGoal()) return navmgr.CheckGoalState();
  if (navmgr.SizeGoalsQueue() > 0) return navmgr.SendGoal(navmgr.FrontGoalsQueue());
  return navmgr.Spin();
}

bool isEvent(SpinResult did)
{
  return did != SpinResult::kNotConnected && did != SpinResult::kDriving && did != SpinResult::kIdle;
}

void drive(NavigationMgr & navmgr, const std::string & mode)
{
  bool over{false};
  for (int left = kSpinsAfterEnd; ros::ok() && left > 0; left -= over ? 1 : 0) {
    const auto did = mode == "parts" ? spinByParts(navmgr) : navmgr.Spin();
    if (isEvent(did)) std::cout << ToString(did) << std::endl;
    if (did == SpinResult::kSent && (mode == "cancel" || navmgr.Results().size() >= kLoopedGoals)) {
      navmgr.ClearGoals();
      navmgr.Cancel();
    }
    if (did == SpinResult::kSent && mode == "drop") navmgr.ClearGoals();
    if (did == SpinResult::kSent && mode == "add" && navmgr.Results().empty()) {
      navmgr.AddGoal(PlanarGoal(9.0, 0.0, 0.0));
    }
    over = over || did == SpinResult::kQueueEmpty;
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "driver", ros::init_options::AnonymousName);
  ros::start();
  const std::string mode{argc > 3 ? argv[3] : ""};
  try {
    NavigationMgr navmgr{argv[1], Timeouts{1.0, 4.0, 1.0, 4.0, 1.0}};
    navmgr.LoadGoals(argv[2]);
    navmgr.SetLoopMode(mode == "loop");
    navmgr.OnGoalReached(print);
    navmgr.OnGoalFailed(print);
    drive(navmgr, mode);
  } catch (const Error & error) {
    std::cout << error.what() << std::endl;
    return 2;
  }
}
