#pragma once

#include <workspace_support/number_rule.h>

namespace f1tenth_sim2d
{
// What may be asked for, so that no time is longer than ROS, which counts seconds in 32 bits, can say.

constexpr double kLeastRealTimeFactor = 1e-6;  ///< simulated seconds per wall second; 0 means something else
constexpr double kLongestPeriod = 1e3;         ///< s

/// Hz, of what comes again and again.
workspace_support::NumberRule frequency();
/// Wall s to wait for somebody.
workspace_support::NumberRule patience();
/// Simulated seconds per wall second.
workspace_support::NumberRule realTimeFactor();
}  // namespace f1tenth_sim2d
