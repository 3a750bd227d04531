#include "node/world/warnings.h"

#include <ros/console.h>

namespace f1tenth_sim2d
{
void warnOnce(const std::string & source, const std::vector<std::string> & warnings)
{
  if (warnings.empty()) {
    return;
  }
  std::string text;
  for (const auto & warning : warnings) {
    text += "\n  " + warning;
  }
  ROS_WARN("%s: not represented:%s", source.c_str(), text.c_str());
}
}  // namespace f1tenth_sim2d
