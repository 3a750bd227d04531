#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// Names in one warning what cannot be represented of a source, if anything.
void warnOnce(const std::string & source, const std::vector<std::string> & warnings);
}  // namespace f1tenth_sim2d
