#pragma once

#include <vector>

#include <move_base/search/arc_price.h>
#include <move_base/search/hybrid_a_star.h>

#include "path/terms.h"

namespace f1tenth_racer
{
/// Where a car that passes a pose without stopping may roll on: the cheapest forward arcs that keep the rule,
/// as long as wanted or as far as the road goes, m.
std::vector<Arc> extensionFrom(
  const Pose2 & pose, const Costmap & costmap, const ClearanceRule & rule, const PlannerOptions & options,
  double wanted_length);
}  // namespace f1tenth_racer
