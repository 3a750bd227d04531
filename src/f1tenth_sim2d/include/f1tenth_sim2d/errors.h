#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

namespace f1tenth_sim2d
{
/// A number as messages show it, with six digits.
inline std::string toText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/// Base of everything this package throws for a user's mistake. Mistakes of our own are asserted.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A world, robot description or parameter file that cannot be used.
class LoadError : public Error
{
public:
  /// @param file    the file as the user named it, or a name like "robot_description of robot1"
  /// @param place   element path ("world[default]/model[walls]/link[Wall_0]") or line; may be empty
  /// @param reason  what was found, and what is allowed
  LoadError(const std::string & file, const std::string & place, const std::string & reason)
  : Error(file + (place.empty() ? "" : ": " + place) + ": " + reason)
  {
  }
};

/// A place at which a car would overlap something; the message names it.
class OccupiedPlace : public Error
{
public:
  using Error::Error;
};
}  // namespace f1tenth_sim2d
