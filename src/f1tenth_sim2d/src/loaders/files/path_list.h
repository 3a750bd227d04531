#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// The parts of "a:b", empty ones left out.
std::vector<std::string> splitPathList(const std::string & text);
}  // namespace f1tenth_sim2d
