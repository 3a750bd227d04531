#pragma once

#include <standin_support/geometry.h>
#include <standin_support/scan.h>

namespace gmapping
{
using standin_support::normalizeAngle;
using standin_support::Pose2;
using standin_support::Scan;
}  // namespace gmapping
