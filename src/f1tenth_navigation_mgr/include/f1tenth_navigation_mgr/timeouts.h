#pragma once

namespace f1tenth_navigation_mgr
{
/// When to doubt the action server. "Both clocks": that long has passed in wall time and in ROS time, so that neither a
/// stopped /clock (pause, lockstep) nor one that runs fifty times faster than wall time counts as silence.
struct Timeouts
{
  double resend{1.0};        ///< wall s without acknowledgement, then the goal or the cancel is resent (same id)
  double acknowledge{10.0};  ///< s, both clocks, then an unacknowledged goal is lost
  double disconnect{2.0};    ///< wall s without connection (its process has died), then the goal is lost
  double silence{5.0};       ///< s, both clocks, without a status message, then the goal is lost
  double result{2.0};  ///< wall s between the status that says the goal is over and its result, then the status counts
  double reconnect{3.0};  ///< wall s without connection and goal, then all topics are connected anew
};
}  // namespace f1tenth_navigation_mgr
