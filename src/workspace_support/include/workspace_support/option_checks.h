#pragma once

#include <cmath>
#include <string>

#include "workspace_support/errors.h"

/// Checks of options, with messages that say which one, what was found and what is allowed.
namespace workspace_support
{
inline void requireOption(bool holds, const std::string & name, double found, const std::string & allowed)
{
  if (!holds) {
    throw OptionError(name + ": found " + toText(found) + ", must be " + allowed);
  }
}

inline void requirePositive(const std::string & name, double found)
{
  requireOption(std::isfinite(found) && found > 0.0, name, found, "a number above 0");
}

inline void requireNotNegative(const std::string & name, double found)
{
  requireOption(std::isfinite(found) && found >= 0.0, name, found, "a number of at least 0");
}
}  // namespace workspace_support
