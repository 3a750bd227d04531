#pragma once

#include <workspace_support/errors.h>

#include <string>

namespace f1tenth_sim2d
{
using workspace_support::Error;
using workspace_support::toText;

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
