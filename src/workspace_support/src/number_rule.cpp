#include "workspace_support/number_rule.h"

#include "workspace_support/errors.h"

namespace workspace_support
{
namespace
{
constexpr double kLongest = 1e9;  // s; ROS counts them in 32 bits
}  // namespace

NumberRule positive()
{
  return {[](double value) { return value > 0.0; }, " > 0"};
}

NumberRule atLeast(double least, const std::string & meaning)
{
  return {[least](double value) { return value >= least; }, " >= " + toText(least) + meaning};
}

NumberRule within(double least, double most)
{
  return {
    [least, most](double value) { return value >= least && value <= most; },
    " >= " + toText(least) + " and <= " + toText(most)};
}

NumberRule duration()
{
  return within(0.0, kLongest);
}
}  // namespace workspace_support
