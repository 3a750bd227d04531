#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <move_base/global_planner.h>
#include "line/corridor.h"
#include "path/terms.h"

namespace f1tenth_racer
{
/// Points at the start of a line that stay: they hold position, heading and curvature.
inline constexpr std::size_t kFixedPoints = 3;

/// Takes room away from the corridor around a line. @return whether there is a way left
using Narrowing = std::function<bool(const Path & line, std::vector<Interval> & corridor)>;

/// The line of least curvature in the free corridor around a path that is driven forwards (Heilmeier et al. 2020): it
/// uses the width of the road so that bends become wide. Pose and curvature at the start stay, the end is free.
/// The result keeps the clearance, m, and the greatest curvature, 1/m, wherever the given path does, and comes no
/// nearer to obstacles elsewhere; it passes the goal as the options say if the path does, and those beyond it where it
/// comes by them and such a line was found. Without a way through the narrowed corridor it is empty.
Path raceLine(
  const Path & path, const Costmap & costmap, double clearance, const Pose2 & goal, double greatest_curvature,
  const RaceLineOptions & options, const Narrowing & narrowing = {});
}  // namespace f1tenth_racer
