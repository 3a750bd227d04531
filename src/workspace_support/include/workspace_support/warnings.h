#pragma once

#include <ros/time.h>

#include <optional>
#include <string>

/// Warnings in wall time: simulated time may stand still, and near time 0 ROS_WARN_THROTTLE is silent.
namespace workspace_support
{
/// "A scan at 1.050 s is left out: REASON"
std::string scanIsLeftOut(const ros::Time & stamp, const std::string & reason);

/// A warning at most every 5 s.
class RareWarning
{
public:
  /// @return whether the warning was given
  bool say(const std::string & text, const ros::WallTime & now = ros::WallTime::now());

private:
  std::optional<ros::WallTime> last_;
};

/// Warns of what a node lacks once it has waited for it for 5 s, and every 5 s from then on.
class WaitWarning
{
public:
  /// To be called repeatedly.
  /// @param missing  "scans on /scan"; empty: nothing
  /// @return whether the warning was given
  bool waitFor(const std::string & missing, const ros::WallTime & now = ros::WallTime::now());
  /// Starts waiting anew, as something has arrived.
  void reset() { missing_.clear(); }

private:
  std::string missing_;
  ros::WallTime since_;  // when the wait began, or was last warned of
};
}  // namespace workspace_support
