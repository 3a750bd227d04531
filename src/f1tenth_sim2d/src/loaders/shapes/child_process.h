#pragma once

#include <string>
#include <vector>

namespace f1tenth_sim2d
{
/// What a reader of files sets itself as limits (RLIMIT_CPU, alarm), for messages to name.
constexpr unsigned kCpuSecondsMax = 60;
constexpr unsigned kWallSecondsMax = 600;

/// Where programs that outputOf runs write their output: libraries print to the other descriptors.
constexpr int kOutputDescriptor = 3;

/// Runs a program and returns what it writes to kOutputDescriptor; blocks until it ends. It gets no other descriptor.
/// @param command  path of the program and its arguments
/// @throws Error with what the program has written if its exit code is not 0, or saying how it ended
std::string outputOf(const std::vector<std::string> & command);
}  // namespace f1tenth_sim2d
