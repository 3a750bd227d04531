#pragma once

#include <standin_support/errors.h>

namespace amcl
{
using standin_support::Error;
using standin_support::OptionError;

/// A map on which nobody can be found.
class MapError : public Error
{
public:
  using Error::Error;
};
}  // namespace amcl
