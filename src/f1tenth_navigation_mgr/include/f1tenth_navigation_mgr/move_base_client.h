#pragma once

#include <actionlib/client/action_client.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "f1tenth_navigation_mgr/goal_result.h"
#include "f1tenth_navigation_mgr/timeouts.h"

namespace f1tenth_navigation_mgr
{
/// One goal at a time on a move_base action server, watched until it is over, whatever becomes of the server.
/// Serves its own callback queue: nothing happens outside its calls. Not thread-safe.
class MoveBaseClient
{
public:
  /// @param ns  namespace of the action `move_base`, resolved like any ROS name
  MoveBaseClient(const std::string & ns, const Timeouts & timeouts);

  /// Handles the messages that have arrived; waits for the first one up to max_wait (wall time).
  void Serve(ros::WallDuration max_wait);

  /// Whether every topic of the action is connected, as of the last Serve().
  bool IsConnected() const;

  /// Whether a goal is in flight and its server has been gone for longer than Timeouts::disconnect.
  bool IsServerGone() const;

  /// @param next  goals that will follow, see Announce()
  /// @pre connected, no goal in flight
  void Send(const Goal & goal, const Goals & next, const ros::Time & now);

  /// Announces on `move_base/goals_ahead` which goals will follow the one in flight, so that the server need not stop
  /// at it; servers that do not listen to it are not affected.
  void Announce(const Goals & next);

  /// How the goal in flight ended, reported once; resends a goal or cancel that the server has not acknowledged.
  std::optional<GoalResult> Check(const ros::Time & now);

  /// Asks the server to give up the goal in flight, once the server has accepted it; Check() tells when that is done.
  void Cancel(const ros::Time & now);

  bool HasGoal() const { return flight_.has_value(); }

  /// "/robot1/move_base"
  std::string ActionName() const { return nh_.resolveName("move_base"); }

  /// Name of the car's frame `odom`: its namespace and "odom", "robot1/odom".
  std::string OdomFrame() const;

private:
  using Client = actionlib::ActionClient<move_base_msgs::MoveBaseAction>;

  /// A moment on both clocks.
  struct Moment
  {
    ros::WallTime wall;
    ros::Time ros;
  };

  struct Flight
  {
    Client::GoalHandle handle;
    Goal goal;
    ros::Time sent;
    Moment asked;  ///< when the goal, or else its cancellation, was sent first
    ros::WallTime last_attempt;
    std::optional<ros::WallTime> over_since;  ///< when the status first said that the goal is over
    bool cancelled{false};
  };

  static bool BothPassed(const Moment & since, const Moment & now, double seconds);

  template <typename Message>
  void Listen(const std::string & topic, const std::function<void()> & heard);
  void Connect();
  void WatchConnection();
  void SendCancel(const ros::Time & now);
  void AskAgain(const ros::WallTime & now);
  bool IsResultOverdue(const Moment & now);
  std::optional<GoalResult> CheckAlive(const Moment & now);
  GoalResult EndAsServerSays(const ros::Time & now);
  GoalResult EndAsLost(const std::string & what, double seconds, const ros::Time & now);
  GoalResult End(GoalOutcome outcome, const std::string & text, const ros::Time & now);

  const Timeouts timeouts_;
  ros::NodeHandle nh_;
  ros::CallbackQueue queue_;
  ros::Publisher goals_ahead_;
  std::unique_ptr<Client> client_;  ///< null until there is a clock: its constructor blocks without one
  ros::WallTime connected_;         ///< when the topics were subscribed and advertised
  double patience_;                 ///< wall s from then until that is done again
  std::vector<ros::Subscriber> listeners_;
  Moment last_status_;
  std::optional<ros::WallTime> gone_since_;
  std::optional<Flight> flight_;
};
}  // namespace f1tenth_navigation_mgr
