#pragma once

#include <workspace_support/option_checks.h>

namespace move_base
{
using workspace_support::Error;
using workspace_support::OptionError;
using workspace_support::requireNotNegative;
using workspace_support::requireOption;
using workspace_support::requirePositive;
}  // namespace move_base
