#include <cstdlib>
#include <sstream>

#include "f1tenth_sim2d/loaders.h"
#include "loaders/files/path_list.h"

namespace f1tenth_sim2d
{
std::vector<std::string> splitPathList(const std::string & text)
{
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, ':');) {
    if (!part.empty()) {
      parts.push_back(part);
    }
  }
  return parts;
}

std::vector<std::string> pathListFromEnvironment(const char * variable)
{
  const char * const value = std::getenv(variable);
  return splitPathList(value ? value : "");
}

SearchPath searchPathFromEnvironment()
{
  return {pathListFromEnvironment("GAZEBO_MODEL_PATH"), pathListFromEnvironment("ROS_PACKAGE_PATH")};
}
}  // namespace f1tenth_sim2d
