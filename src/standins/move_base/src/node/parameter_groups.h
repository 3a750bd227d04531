#pragma once

#include <workspace_support/parameter_reader.h>

#include "parameters.h"

/// The parts of readSetup(). @throws OptionError for a parameter of a wrong type or out of range
namespace move_base
{
void readCostmaps(ParameterReader & reader, MoveBaseParameters & parameters);
}  // namespace move_base
