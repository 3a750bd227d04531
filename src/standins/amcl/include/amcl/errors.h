#pragma once

#include <workspace_support/errors.h>

namespace amcl
{
using workspace_support::Error;
using workspace_support::OptionError;

/// A map on which nobody can be found.
class MapError : public Error
{
public:
  using Error::Error;
};
}  // namespace amcl
