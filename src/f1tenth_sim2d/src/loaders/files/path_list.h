#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// The parts of "a:b", empty ones left out.
std::vector<std::string> splitPathList(const std::string & text);

/// Those of an environment variable; none if it is not set.
std::vector<std::string> pathListFromEnvironment(const char * variable);
}  // namespace f1tenth_sim2d
