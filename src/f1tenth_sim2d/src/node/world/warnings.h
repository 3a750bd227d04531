#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// Says in one warning what of a source cannot be represented, if anything.
void warnOnce(const std::string & source, const std::vector<std::string> & warnings);
}  // namespace f1tenth_sim2d
