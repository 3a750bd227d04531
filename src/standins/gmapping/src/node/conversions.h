#pragma once

#include <workspace_support/conversions.h>

/// Between messages and the core's types.
namespace gmapping
{
using workspace_support::fromLaserScan;
using workspace_support::fromTransform;
using workspace_support::headerOf;
using workspace_support::isUpsideDown;
using workspace_support::toOccupancyGrid;
using workspace_support::toTransform;
}  // namespace gmapping
