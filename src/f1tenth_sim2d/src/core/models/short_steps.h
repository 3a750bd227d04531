#pragma once

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
/// Calls advance(step) for equal parts of a step of dt seconds that are no longer than 1 ms: the stiffest case of the
/// single-track model (v = 0.1 m/s) is stable up to 2.5 ms.
template <typename Advance>
void inShortSteps(double dt, Advance advance)
{
  constexpr double kLongest = 0.001;  // s
  const int count = std::max(1, static_cast<int>(std::ceil(dt / kLongest - 1e-9)));
  for (int i = 0; i < count; ++i) {
    advance(dt / count);
  }
}
}  // namespace f1tenth_sim2d
