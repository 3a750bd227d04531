#pragma once

#include <cmath>
#include <cstdint>

namespace f1tenth_sim2d
{
/// Simulated time, ns since the start.
using SimTime = std::int64_t;

constexpr double kNanosecondsPerSecond = 1e9;

inline SimTime fromSeconds(double seconds)
{
  return std::llround(seconds * kNanosecondsPerSecond);
}
inline double toSeconds(SimTime time)
{
  return static_cast<double>(time) / kNanosecondsPerSecond;
}
}  // namespace f1tenth_sim2d
