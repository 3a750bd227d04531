#pragma once

#include <workspace_support/errors.h>

namespace move_base
{
using workspace_support::Error;
using workspace_support::OptionError;
}  // namespace move_base
