#pragma once

#include <ros/callback_queue.h>
#include <ros/message_event.h>
#include <ros/subscriber.h>
#include <std_msgs/Int32.h>

#include <cstdint>
#include <optional>
#include <string>

namespace f1tenth_navigation_mgr
{
/// Reads the countdown to the start of the race: std_msgs/Int32, latched, whole seconds left; 0 is the start.
/// Subscribes on a callback queue of its own, served by SecondsLeft(): in lockstep a participant's drain has by then
/// put everything into it that belongs to the period. Not thread-safe.
class StartSignal
{
public:
  /// @param starter  the only node whose announcements count, with the leading slash; empty: anybody's
  explicit StartSignal(const std::string & topic = "/time_to_start", std::string starter = "");

  /// s, as last announced; empty before the first announcement. Does not block.
  std::optional<std::int32_t> SecondsLeft();

  /// Whether the race is on; it stays on.
  bool HasStarted();

private:
  void take(const ros::MessageEvent<const std_msgs::Int32> & event);

  const std::string starter_;
  ros::CallbackQueue queue_;
  ros::Subscriber subscriber_;
  std::optional<std::int32_t> seconds_left_;
  bool started_{false};
};
}  // namespace f1tenth_navigation_mgr
