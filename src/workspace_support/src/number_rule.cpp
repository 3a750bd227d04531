#include "workspace_support/number_rule.h"

#include <sstream>

namespace workspace_support
{
namespace
{
std::string shown(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}
}  // namespace

NumberRule positive()
{
  return {[](double value) { return value > 0.0; }, " > 0"};
}

NumberRule atLeast(double least, const std::string & meaning)
{
  return {[least](double value) { return value >= least; }, " >= " + shown(least) + meaning};
}
}  // namespace workspace_support
