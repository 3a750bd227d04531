#pragma once

#include <vector>

#include "move_base/path/path.h"

namespace move_base
{
/// Signed curvature of the circle through three points, positive when it turns to the left, 1/m.
double curvatureThrough(const Vec2 & a, const Vec2 & b, const Vec2 & c);

/// The path forwards through points; the first one keeps the heading and curvature of start.
Path pathThrough(const std::vector<Vec2> & points, const PathPoint & start);

/// The same path with its points equally far apart, as many as before.
Path resampled(const Path & path);
}  // namespace move_base
