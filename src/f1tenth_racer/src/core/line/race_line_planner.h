#pragma once

#include <move_base/planning/way_planner.h>

#include <memory>

#include "path/terms.h"

namespace f1tenth_racer
{
/// Hybrid A* whose ways become race lines where one is asked for.
/// @throws OptionError
std::unique_ptr<GlobalPlanner> makeRaceLinePlanner(const PlannerOptions & options);
}  // namespace f1tenth_racer
