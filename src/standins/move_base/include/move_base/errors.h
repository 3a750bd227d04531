#pragma once

#include <stdexcept>

namespace move_base
{
/// Base of everything this package throws for a user's mistake. Mistakes of our own are asserted.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Options that cannot be used: which one, what was found, what is allowed.
class OptionError : public Error
{
public:
  using Error::Error;
};
}  // namespace move_base
