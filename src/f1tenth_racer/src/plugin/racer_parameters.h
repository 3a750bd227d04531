#pragma once

#include <move_base/global_planner.h>

#include "control/racer_options.h"

namespace f1tenth_racer
{
/// The options under the namespace of the local planner, or right under the node.
/// @throws OptionError for a parameter of a wrong type or out of range
RacerOptions readRacer(const PlannerSetup & setup);
}  // namespace f1tenth_racer
