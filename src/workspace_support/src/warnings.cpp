#include "workspace_support/warnings.h"

#include <ros/console.h>

#include <iomanip>
#include <sstream>

namespace workspace_support
{
namespace
{
const ros::WallDuration kPatience{5.0};
}  // namespace

std::string scanIsLeftOut(const ros::Time & stamp, const std::string & reason)
{
  std::ostringstream text;
  text << "A scan at " << std::fixed << std::setprecision(3) << stamp.toSec() << " s is left out: " << reason;
  return text.str();
}

bool RareWarning::say(const std::string & text, const ros::WallTime & now)
{
  if (last_ && now - *last_ < kPatience) {
    return false;
  }
  ROS_WARN("%s", text.c_str());
  last_ = now;
  return true;
}

bool WaitWarning::waitFor(const std::string & missing, const ros::WallTime & now)
{
  if (missing != missing_) {
    missing_ = missing;
    since_ = now;
  }
  if (missing.empty() || now - since_ < kPatience) {
    return false;
  }
  ROS_WARN("Still waiting for %s", missing.c_str());
  since_ = now;
  return true;
}
}  // namespace workspace_support
