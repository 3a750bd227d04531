#pragma once

#include <standin_support/errors.h>

namespace gmapping
{
using standin_support::Error;
using standin_support::OptionError;
}  // namespace gmapping
