#pragma once

#include "loaders/xml/element.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// Warns of children of a <world>, <model>, <link>, <inertial>, <collision> or shape that have no counterpart in the
/// simulation, each with the reason, and of those that SDF does not know: they may be misspelt.
void warnOfChildren(const Element & parent, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
