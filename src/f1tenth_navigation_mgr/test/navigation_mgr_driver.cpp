// Drives the C++ class as navigation_mgr_driver.py drives the Python one; behaviour_test.py compares what they print.
//   navigation_mgr_test_driver ROBOT GOALS_FILE [loop|cancel|parts|add|drop]
#include <ros/ros.h>

#include <iostream>
#include <map>

#include "f1tenth_navigation_mgr/navigation_mgr.h"

using namespace f1tenth_navigation_mgr;

namespace
{
constexpr std::size_t kLoopedGoals{5};
constexpr int kSpinsAfterEnd{5};

const std::map<GoalOutcome, const char *> kOutcomes{
  {GoalOutcome::kSucceeded, "succeeded"},
  {GoalOutcome::kAborted, "aborted"},
  {GoalOutcome::kRejected, "rejected"},
  {GoalOutcome::kPreempted, "preempted"},
  {GoalOutcome::kLost, "lost"}};

// The others are nothing that has happened.
const std::map<SpinResult, const char *> kEvents{
  {SpinResult::kSent, "sent"},
  {SpinResult::kReached, "reached"},
  {SpinResult::kFailed, "failed"},
  {SpinResult::kQueueEmpty, "queue_empty"}};

void print(const GoalResult & result)
{
  std::cout << "goal " << result.goal.x << " " << kOutcomes.at(result.outcome) << ": " << result.text << std::endl;
}

// The thesis's Spin, with its names.
SpinResult spinByParts(NavigationMgr & navmgr)
{
  if (navmgr.HasActiveGoal()) return navmgr.CheckGoalState();
  if (navmgr.SizeGoalsQueue() > 0) return navmgr.SendGoal(navmgr.FrontGoalsQueue());
  return navmgr.Spin();
}

void drive(NavigationMgr & navmgr, const std::string & mode)
{
  bool over{false};
  for (int left = kSpinsAfterEnd; ros::ok() && left > 0; left -= over ? 1 : 0) {
    const auto did = mode == "parts" ? spinByParts(navmgr) : navmgr.Spin();
    if (const auto event = kEvents.find(did); event != kEvents.end()) std::cout << event->second << std::endl;
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
