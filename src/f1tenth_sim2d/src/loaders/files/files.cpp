#include "loaders/files/files.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <sstream>

#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"

namespace f1tenth_sim2d
{
bool isFile(const std::string & path)
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

std::string readFile(const std::string & path)
{
  std::error_code ignored;
  // Opening a folder succeeds; what reading it throws does not name it.
  if (std::filesystem::is_directory(path, ignored)) {
    throw LoadError(path, "", "is a folder, not a file");
  }
  std::ifstream file(path, std::ios::binary);
  try {
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (file) {
      return bytes;
    }
  } catch (const std::ios_base::failure &) {  // of the device; iterators bypass the stream, which would catch it
  }
  throw LoadError(path, "", "no such file, or it cannot be read");
}

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
  SearchPath path{pathListFromEnvironment("GAZEBO_MODEL_PATH"), pathListFromEnvironment("ROS_PACKAGE_PATH")};
  const std::vector<std::string> resources = pathListFromEnvironment("GAZEBO_RESOURCE_PATH");
  path.model_folders.insert(path.model_folders.end(), resources.begin(), resources.end());
  return path;
}
}  // namespace f1tenth_sim2d
