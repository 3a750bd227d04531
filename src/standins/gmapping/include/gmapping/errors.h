#pragma once

#include <workspace_support/errors.h>

namespace gmapping
{
using workspace_support::Error;
using workspace_support::OptionError;
}  // namespace gmapping
