#pragma once

#include <cmath>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
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
