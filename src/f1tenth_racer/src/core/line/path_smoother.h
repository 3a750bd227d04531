#pragma once

#include <move_base/map/costmap.h>
#include <move_base/path/path.h>
#include <move_base/search/arc_price.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// Evens out the steering of a path and moves it away from obstacles: an elastic band (snake) within each stretch of
/// one driving direction. Both ends of a stretch and the point at pinned_s keep pose and heading.
/// The result keeps rule and greatest curvature, 1/m, wherever the given path does; where it would not, it stays as given.
Path smoothPath(
  const Path & path, const Costmap & costmap, const ClearanceRule & rule, double greatest_curvature, double pinned_s);
}  // namespace f1tenth_racer
