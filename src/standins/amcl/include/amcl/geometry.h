#pragma once

#include <workspace_support/grid.h>
#include <workspace_support/planar.h>
#include <workspace_support/scan.h>

namespace amcl
{
using workspace_support::distance;
using workspace_support::normalizeAngle;
using workspace_support::OccupancyGrid;
using workspace_support::Pose2;
using workspace_support::Scan;
}  // namespace amcl
