#pragma once

#include "loaders/xml/element.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// Warns of elements and attributes of links and joints that URDF does not know: a misspelt one would be passed over.
/// What a car looks like, and tags with a prefix ("xacro:"), may hold anything.
void warnOfUnknownUrdf(const Element & robot, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
