#pragma once

#include <ros/duration.h>
#include <ros/time.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_navigation_mgr/errors.h"
#include "f1tenth_navigation_mgr/goal_result.h"
#include "f1tenth_navigation_mgr/goals_file.h"
#include "f1tenth_navigation_mgr/move_base_client.h"
#include "f1tenth_navigation_mgr/timeouts.h"

namespace f1tenth_navigation_mgr
{
/// What one Spin() did.
enum class SpinResult
{
  kNotConnected,  ///< nothing: there is no clock yet, or the action server is not connected
  kDriving,       ///< checked the goal in flight: not over yet
  kSent,          ///< sent the front of the queue
  kReached,       ///< the goal in flight was reached
  kFailed,        ///< the goal in flight ended otherwise
  kQueueEmpty,    ///< found the queue empty, for the first time since it had goals
  kIdle,          ///< nothing: the queue is still empty
};

/// Sends a car's goals to its move_base, one after the other.
///
///     NavigationMgr navmgr{"robot1"};
///     navmgr.LoadGoals("navigation_goals.txt");
///     while (ros::ok()) navmgr.Spin();
///
/// Serves its own callback queue inside Spin() and WaitForServer(), so it works with and without ros::spin(), and
/// nothing changes between two calls. Not thread-safe.
class NavigationMgr
{
public:
  using ResultCallback = std::function<void(const GoalResult &)>;

  /// @param robot  the car's namespace, resolved like any ROS name: the action is `<robot>/move_base`; empty: the
  ///               namespace of the node. Call ros::init() first.
  explicit NavigationMgr(const std::string & robot, const Timeouts & timeouts = {});

  /// Appends the goals of a file to the queue. Known frames: `map` and the car's `odom`.
  /// @throws GoalsFileError; the queue is then unchanged
  void LoadGoals(const std::string & path);
  void AddGoal(const Goal & goal);

  /// Drops the goals not yet sent; the goal in flight stays.
  void ClearGoals();

  /// In loop mode a reached goal goes to the back of the queue instead of leaving it.
  void SetLoopMode(bool loop);
  bool LoopMode() const { return loop_mode_; }

  /// Does at most one thing: nothing while the action server is not connected; else checks the goal in flight; else
  /// sends the front of the queue; else reports an empty queue. A goal that failed leaves the queue, in loop mode too.
  /// Waits up to 10 ms of wall time for a message, so that a bare loop around it does not burn a processor.
  SpinResult Spin();

  /// The same without waiting, at a ROS time given by the caller: for lockstep, where the period's stamp counts.
  SpinResult Spin(const ros::Time & now);

  /// The parts of Spin(), named as in the thesis, to write another one from.
  bool HasActiveGoal() const { return client_.HasGoal(); }
  std::size_t SizeGoalsQueue() const { return queue_.size(); }
  /// @throws Error when the queue is empty
  const Goal & FrontGoalsQueue() const;
  /// Removes a goal that is over from the queue, as Spin() does; waits up to 10 ms of wall time for a message.
  /// @return kNotConnected, kDriving, kReached or kFailed; kIdle when there is no active goal
  SpinResult CheckGoalState();
  /// Sends a goal, which becomes the front of the queue unless it already is.
  /// @return kSent, or kNotConnected, and then nothing has changed
  /// @throws Error when another goal is active
  SpinResult SendGoal(const Goal & goal);

  /// Blocks until there is a clock and the action server is connected, or timeout (wall time) has passed.
  /// @return whether it is connected
  bool WaitForServer(ros::WallDuration timeout);

  /// Whether a goal is in flight and its server has been gone for longer than Timeouts::disconnect: the next Spin()
  /// reports it as lost. For callers that spin only when the clock moves, which may have stopped with the server.
  bool IsServerGone();

  /// Asks the server to cancel the goal in flight; a later Spin() reports it, as kPreempted unless it was over before.
  void Cancel();

  /// The goal that the car is driving to, if any.
  std::optional<Goal> GoalInFlight() const;

  /// Goals not reached yet, including the one in flight.
  std::size_t GoalsLeft() const { return queue_.size(); }
  Goals Queue() const { return {queue_.begin(), queue_.end()}; }

  /// One entry per goal that is over, in order.
  const std::vector<GoalResult> & Results() const { return results_; }

  /// Called inside Spin(). What they throw leaves Spin(), which has then done its work.
  void OnGoalReached(ResultCallback callback) { on_reached_ = std::move(callback); }
  void OnGoalFailed(ResultCallback callback) { on_failed_ = std::move(callback); }

  /// "/robot1/move_base"
  std::string ActionName() const { return client_.ActionName(); }

private:
  SpinResult SpinOnce(const ros::Time & now);
  bool CanSpin() const;
  Goals NextGoals() const;
  void AnnounceNext();
  SpinResult CheckGoal(const ros::Time & now);
  SpinResult SendFront(const ros::Time & now);
  SpinResult ReportEmpty();
  SpinResult Finish(const GoalResult & result);

  MoveBaseClient client_;
  std::deque<Goal> queue_;  ///< its front is the goal in flight if there is one
  std::vector<GoalResult> results_;
  ResultCallback on_reached_;
  ResultCallback on_failed_;
  bool loop_mode_{false};
  bool empty_reported_{false};
};
}  // namespace f1tenth_navigation_mgr

// The class is used by its bare name.
using f1tenth_navigation_mgr::NavigationMgr;
