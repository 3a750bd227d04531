#pragma once

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>

namespace move_base
{
/// What the car does, and if it stands still, why: on /diagnostics.
class Diagnostics
{
public:
  /// @param base_frame  of the car, for tools that show it there
  Diagnostics(ros::NodeHandle node, const std::string & base_frame);

  /// Publishes what is new at once, and the rest once a second.
  /// @param level  of DiagnosticStatus
  void tell(int level, const std::string & text, const ros::Time & now);

private:
  ros::Publisher publisher_;
  diagnostic_msgs::DiagnosticStatus status_;
  std::optional<ros::Time> told_;
};
}  // namespace move_base
