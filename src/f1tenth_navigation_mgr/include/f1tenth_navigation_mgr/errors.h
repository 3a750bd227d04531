#pragma once

#include <stdexcept>

namespace f1tenth_navigation_mgr
{
/// What this package throws; what() is one line for the user.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A goals file that cannot be read; what() begins with FILE: or FILE:LINE:
class GoalsFileError : public Error
{
public:
  using Error::Error;
};
}  // namespace f1tenth_navigation_mgr
