#pragma once

#include <cstdint>
#include <string>

namespace f1tenth_sim2d
{
/// A URDF with <gazebo> tags that follows from the seed.
std::string randomUrdf(std::uint32_t seed);
}  // namespace f1tenth_sim2d
