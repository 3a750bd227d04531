#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// Whether a path names an existing file that may be accessed.
bool isFile(const std::string & path);

/// The bytes of a file.
/// @throws LoadError for one that is not there, that is a folder, or that cannot be read
std::string readFile(const std::string & path);

/// The parts of "a:b", empty ones left out.
std::vector<std::string> splitPathList(const std::string & text);

/// Those of an environment variable; none if it is not set.
std::vector<std::string> pathListFromEnvironment(const char * variable);
}  // namespace f1tenth_sim2d
