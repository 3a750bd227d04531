#pragma once

#include <string>

#include "move_base/global_planner.h"

namespace move_base
{
/// Why a car gets no plan.
struct Obstruction
{
  std::string reason;   ///< a sentence for a person to read
  bool lasting{false};  ///< whether the map alone is to blame: nothing that the car may see or do changes it
};

/// Why the car can never stand at a goal, by the map alone; empty if it can.
std::string wrongWith(const Pose2 & goal, const Costmap & costmap);

/// @param status  with which planning failed on the costmap
Obstruction obstructionOf(const Costmap & costmap, const PlanRequest & request, SearchStatus status);
}  // namespace move_base
