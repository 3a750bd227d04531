#pragma once

#include "move_base/global_planner.h"

namespace move_base
{
/// A plan to a goal, or, where there is none, to the first place around it that one leads to, as move_base's make_plan
/// searches: square by square, three cells apart, as far as the tolerance. All tries together have the request's max_expansions.
/// @param tolerance  m along each axis
Plan planNear(const GlobalPlanner & planner, const Costmap & costmap, const PlanRequest & request, double tolerance);
}  // namespace move_base
