#pragma once

#include <cstdint>
#include <string>

#include "../temp_folder.h"

namespace f1tenth_sim2d
{
/// Writes a world that follows from the seed, with the models that it includes, into the folder.
/// @return the path of the world
std::string writeRandomWorld(std::uint32_t seed, const TempFolder & folder);
}  // namespace f1tenth_sim2d
