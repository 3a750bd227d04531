#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <standin_support/conversions.h>

#include "gmapping/occupancy_grid.h"

/// Between messages and the core's types.
namespace gmapping
{
using standin_support::fromLaserScan;
using standin_support::fromTransform;
using standin_support::isUpsideDown;
using standin_support::toTransform;

nav_msgs::OccupancyGrid toOccupancyGrid(const OccupancyGrid & grid, const std_msgs::Header & header);
}  // namespace gmapping
