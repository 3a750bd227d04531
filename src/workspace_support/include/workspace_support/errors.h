#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace workspace_support
{
/// A number as messages show it, with six digits.
inline std::string toText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/// Base of everything that simulator and stand-ins throw for a user's mistake. Our own mistakes are asserted.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A parameter that makes no sense; the message names it, what was found and what is allowed.
class OptionError : public Error
{
public:
  using Error::Error;
};
}  // namespace workspace_support
