#pragma once

#include <cmath>

#include "workspace_support/option_checks.h"
#include "workspace_support/scan.h"

namespace workspace_support
{
/// Checks that a scan defines where its beams are. Ranges may be anything: an invalid one is a beam without an echo.
/// @throws Error that names the field: "range_max: found inf, must be a finite number above 0"
inline void requireUsable(const Scan & scan)
{
  const bool turns = std::isfinite(scan.angle_increment) && scan.angle_increment != 0.0;
  requireOption(std::isfinite(scan.angle_min), "angle_min", scan.angle_min, "a finite number");
  requireOption(turns, "angle_increment", scan.angle_increment, "a finite number other than 0");
  requireOption(std::isfinite(scan.range_min), "range_min", scan.range_min, "a finite number");
  requireOption(
    std::isfinite(scan.range_max) && scan.range_max > 0.0, "range_max", scan.range_max, "a finite number above 0");
}
}  // namespace workspace_support
