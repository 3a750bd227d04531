#include "diagnostics.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/this_node.h>

namespace move_base
{
namespace
{
const ros::Duration kInterval{1.0};
}

Diagnostics::Diagnostics(ros::NodeHandle node, const std::string & base_frame)
: publisher_(node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10))
{
  status_.hardware_id = ros::this_node::getName().substr(1);
  status_.name = status_.hardware_id + ": driving";
  diagnostic_msgs::KeyValue frame;
  frame.key = "frame";
  frame.value = base_frame;
  status_.values = {frame};
}

void Diagnostics::tell(int level, const std::string & text, const ros::Time & now)
{
  const bool due = !told_ || now < *told_ || now - *told_ >= kInterval;
  if (!due && text == status_.message) {
    return;
  }
  status_.level = static_cast<diagnostic_msgs::DiagnosticStatus::_level_type>(level);
  status_.message = text;
  told_ = now;
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = now;
  message.status = {status_};
  publisher_.publish(message);
}
}  // namespace move_base
