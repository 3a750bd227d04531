#pragma once

#include <workspace_support/number_rule.h>

/// What may be asked for, so that no time is longer than ROS, which counts seconds in 32 bits, can represent.
namespace f1tenth_sim2d
{
constexpr double kLeastRealTimeFactor = 1e-6;  ///< simulated seconds per wall second; 0 means something else
constexpr double kLongestPeriod = 1e3;         ///< s

/// Hz, of what recurs. No physics step is as short as a period of the greatest.
inline workspace_support::NumberRule frequency()
{
  return workspace_support::within(1.0 / kLongestPeriod, 1e6);
}

/// Wall s to wait for somebody.
inline workspace_support::NumberRule patience()
{
  return {[](double value) { return value > 0.0 && value <= 1e9; }, " > 0 and <= 1e+09"};
}

/// Simulated seconds per wall second.
inline workspace_support::NumberRule realTimeFactor()
{
  return {
    [](double value) { return value == 0.0 || value >= kLeastRealTimeFactor; },
    " that is 0 (as fast as it goes) or >= 1e-06"};
}
}  // namespace f1tenth_sim2d
