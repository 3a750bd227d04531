#include "loaders/model/car_context.h"

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cctype>

namespace f1tenth_sim2d
{
namespace
{
bool isIn(char letter, const char * marks)
{
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || std::string(marks).find(letter) != std::string::npos;
}
}  // namespace

void requireRosName(const Element & place, const std::string & what, const std::string & name)
{
  const bool begins_well = name.empty() || name[0] == '/' || std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  if (!begins_well || !std::all_of(name.begin(), name.end(), [](char letter) { return isIn(letter, "_/"); })) {
    place.fail(
      what + " '" + name + "' is no ROS name; allowed are letters, digits, _ and /, beginning with a letter or /");
  }
}

namespace
{
void requireTopic(const Element & place, const std::string & name)
{
  requireRosName(place, "topic", name);
  if (name.empty() || name.back() == '/' || name.find("//") != std::string::npos) {
    place.fail(
      "'" + name +
      "' is no topic; allowed are names with a / in front or between them, neither doubled nor at the end");
  }
}
}  // namespace

std::string frameId(const Element & place, const std::string & given)
{
  const std::string frame = given.substr(!given.empty() && given.front() == '/' ? 1 : 0);
  if (frame.empty() || !std::all_of(frame.begin(), frame.end(), [](char letter) { return isIn(letter, "_/.-:"); })) {
    place.fail("frame '" + given + "' is no frame id; allowed are letters, digits, _, /, ., - and :");
  }
  return frame;
}

std::string CarContext::rosNamespace(const Element & plugin) const
{
  const std::string given = plugin.child("robotNamespace").text();
  requireRosName(plugin, "<robotNamespace>", given);
  const std::string space = boost::algorithm::trim_copy_if(given, boost::algorithm::is_any_of("/"));
  return given.empty() || space == car.ros_namespace ? "" : "/" + space;
}

std::string CarContext::topic(const Element & plugin, const std::string & given) const
{
  requireTopic(plugin, given);
  const std::string own = car.ros_namespace.empty() ? "/" : "/" + car.ros_namespace + "/";
  if (given.front() == '/') {
    return given.rfind(own, 0) == 0 ? given.substr(own.size()) : given;
  }
  const std::string space = rosNamespace(plugin);
  return space.empty() ? given : space + (space == "/" ? "" : "/") + given;
}

std::string libraryName(const Element & plugin)
{
  const std::string filename = plugin.attribute("filename");
  return filename.substr(filename.find_last_of('/') + 1);
}
}  // namespace f1tenth_sim2d
