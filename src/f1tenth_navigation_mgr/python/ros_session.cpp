#include "ros_session.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <ros/init.h>
#include <ros/master.h>

#include <array>
#include <string>
#include <vector>

#include "f1tenth_navigation_mgr/errors.h"

namespace py = pybind11;

namespace
{
/// `~` parameters, node name and log file belong to the rospy half.
bool concernsBothHalves(const std::string & argument)
{
  static const std::array<std::string, 4> kSpecial{"__ns:=", "__master:=", "__ip:=", "__hostname:="};
  if (argument.find(":=") == std::string::npos) return false;
  if (argument.front() != '_') return true;
  for (const auto & special : kSpecial) {
    if (argument.compare(0, special.size(), special) == 0) return true;
  }
  return false;
}

ros::M_string remappingsOf(const std::vector<std::string> & arguments)
{
  ros::M_string remappings;
  for (const auto & argument : arguments) {
    if (!concernsBothHalves(argument)) continue;
    const auto separator = argument.find(":=");
    remappings[argument.substr(0, separator)] = argument.substr(separator + 2);
  }
  return remappings;
}

/// The name of the rospy half without its namespace; empty if this process has none.
std::string rospyName()
{
  const auto rospy = py::module_::import("rospy");
  const auto name = rospy.attr("core").attr("is_initialized")().cast<bool>()
                      ? rospy.attr("get_name")().cast<std::string>()
                      : std::string{};
  return name.substr(name.rfind('/') + 1);
}

std::vector<std::string> commandLine()
{
  const auto sys = py::module_::import("sys");
  return py::hasattr(sys, "argv") ? sys.attr("argv").cast<std::vector<std::string>>() : std::vector<std::string>{};
}
}  // namespace

void ensureRos()
{
  if (ros::isStarted()) return;
  const auto remappings = remappingsOf(commandLine());
  const auto rospy_name = rospyName();
  {
    const py::gil_scoped_release release;
    if (!ros::isInitialized()) {
      const auto is_alone = rospy_name.empty() ? ros::init_options::AnonymousName : 0;
      ros::init(
        remappings, rospy_name.empty() ? "navigation_mgr" : rospy_name + "_roscpp",
        ros::init_options::NoSigintHandler | is_alone);
    }
    if (!ros::master::check()) {
      throw f1tenth_navigation_mgr::Error{"no ROS master at " + ros::master::getURI()};
    }
    // A NodeHandle would start ROS as well, but then the last one to go would end it.
    ros::start();
  }
  py::module_::import("atexit").attr("register")(py::cpp_function([] {
    const py::gil_scoped_release release;
    ros::shutdown();
  }));
}
