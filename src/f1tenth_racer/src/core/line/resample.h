#pragma once

#include <vector>

#include <move_base/path/path.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// The path forwards through points; the first one keeps the heading and curvature of start.
Path pathThrough(const std::vector<Vec2> & points, const PathPoint & start);

/// The same path with its points equally far apart, as many as before.
Path resampled(const Path & path);
}  // namespace f1tenth_racer
