#pragma once

#include <workspace_support/option_checks.h>

namespace amcl
{
using workspace_support::Error;
using workspace_support::OptionError;
using workspace_support::requireNotNegative;
using workspace_support::requireOption;
using workspace_support::requirePositive;

/// A map on which nobody can be found.
class MapError : public Error
{
public:
  using Error::Error;
};
}  // namespace amcl
