#pragma once

#include "path/global_planner.h"

namespace move_base
{
/// How far along the path the goal is, m: at its nearest point, among those near to near_s.
double placeOnPath(const Path & path, const Pose2 & goal, double near_s);

/// Puts what leads to the start of a plan's path in front of it.
void prepend(const Path & lead, Plan & plan);
}  // namespace move_base
