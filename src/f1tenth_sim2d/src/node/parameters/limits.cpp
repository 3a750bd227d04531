#include "node/parameters/limits.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kMostPatience = 1e9;  // s
constexpr double kFastest = 1e6;       // Hz: no physics step is as short as a period of it
}  // namespace

workspace_support::NumberRule frequency()
{
  return workspace_support::within(1.0 / kLongestPeriod, kFastest);
}

workspace_support::NumberRule patience()
{
  return {[](double value) { return value > 0.0 && value <= kMostPatience; }, " > 0 and <= 1e+09"};
}

workspace_support::NumberRule realTimeFactor()
{
  return {
    [](double value) { return value == 0.0 || value >= kLeastRealTimeFactor; },
    " that is 0 (as fast as it goes) or >= 1e-06"};
}
}  // namespace f1tenth_sim2d
