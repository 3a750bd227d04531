#pragma once

#include <functional>
#include <string>

namespace workspace_support
{
/// What a number must be besides finite.
struct NumberRule
{
  std::function<bool(double)> allows{[](double) { return true; }};
  std::string range;  ///< as error messages say it behind "a number": " > 0"
};

NumberRule positive();
/// @param meaning  of the least value, as error messages say it: " (0: never)"
NumberRule atLeast(double least, const std::string & meaning = "");
NumberRule within(double least, double most);
/// For what is added to stamps, s: the sum must still be a valid time.
NumberRule duration();
}  // namespace workspace_support
