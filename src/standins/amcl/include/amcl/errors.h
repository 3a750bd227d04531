#pragma once

#include <stdexcept>

namespace amcl
{
/// Base of everything this package throws for a user's mistake. Mistakes of our own are asserted.
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

/// A map on which nobody can be found.
class MapError : public Error
{
public:
  using Error::Error;
};
}  // namespace amcl
