#pragma once

#include <functional>
#include <vector>

#include "path/corridor.h"
#include "path/global_planner.h"

namespace move_base
{
/// A pose that a line must pass near to.
struct Gate
{
  Pose2 pose;
  double tolerance{0.0};        ///< m
  double yaw_tolerance{0.0};    ///< rad
  std::vector<Pose2> beyond{};  ///< passed as near, heading aside, where the line leads by them
};

/// Takes room away from the corridor around a line. @return whether there is a way left
using Narrowing = std::function<bool(const Path & line, std::vector<Interval> & corridor)>;

/// The line of least curvature in the free corridor around a path that is driven forwards (Heilmeier et al. 2020): it
/// uses the width of the road so that bends become wide. Pose and curvature at the start stay, the end is free.
/// The result keeps the clearance, m, and the greatest curvature, 1/m, wherever the given path does, and comes no nearer
/// to obstacles elsewhere; it passes the gate if the path does. Without a way through the narrowed corridor it is empty.
Path raceLine(
  const Path & path, const Costmap & costmap, double clearance, const Gate & gate, double greatest_curvature,
  const RaceLineOptions & options, const Narrowing & narrowing = {});
}  // namespace move_base
