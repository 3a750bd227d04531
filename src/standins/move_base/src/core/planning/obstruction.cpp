#include "move_base/planning/obstruction.h"

#include <cmath>

#include "move_base/search/hybrid_a_star.h"
#include "search/cost_to_go.h"

namespace move_base
{
std::string wrongWith(const Pose2 & goal, const Costmap & costmap)
{
  Costmap map = costmap;
  map.forgetAll();
  const GridGeometry & geometry = map.geometry();
  const Cell cell = geometry.cellAt(goal.position());
  if (!geometry.contains(cell)) {
    return "The goal is outside of the map.";
  }
  if (map.clearance(goal) >= 0.0) {
    return "";
  }
  if (map.wallDistance(goal.position()) <= 0.0) {
    return map.isUnknown(geometry.index(cell)) ? "The map is unknown at the goal." : "The goal is in a wall.";
  }
  return "At the goal the car would touch a wall, or reach into where the map is unknown.";
}

Obstruction obstructionOf(const Costmap & costmap, const PlanRequest & request, SearchStatus status)
{
  if (status == SearchStatus::kStartBlocked) {
    const bool in_wall = !wrongWith(request.start, costmap).empty();
    return {
      in_wall
        ? "The car stands in a wall of the map; start it elsewhere, for example with x:= y:= yaw:= of its launch file."
        : "The car touches something where it stands.",
      false};
  }
  if (status == SearchStatus::kGoalBlocked) {
    const std::string wrong = wrongWith(request.goal, costmap);
    return wrong.empty() ? Obstruction{"The lidar sees something at the goal.", false} : Obstruction{wrong, true};
  }
  Costmap map = costmap;
  map.forgetAll();
  if (!std::isfinite(CostToGo(map, request.goal.position()).at(request.start.position()))) {
    return {"No way leads to the goal.", true};
  }
  if (!std::isfinite(CostToGo(costmap, request.goal.position()).at(request.start.position()))) {
    return {"What the lidar sees closes the way to the goal.", false};
  }
  if (status == SearchStatus::kBudgetSpent) {
    return {"No way to the goal was found within max_expansions.", false};
  }
  return {"The way to the goal is too narrow or too winding for the car.", false};
}
}  // namespace move_base
