#include "move_base/planning/obstruction.h"

#include <cmath>

#include "move_base/search/hybrid_a_star.h"
#include "search/cost_to_go.h"

namespace move_base
{
namespace
{
Obstruction atGoal(const Costmap & map, const Pose2 & goal)
{
  const GridGeometry & geometry = map.geometry();
  const Cell cell = geometry.cellAt(goal.position());
  if (!geometry.contains(cell)) {
    return {"The goal is outside of the map.", true};
  }
  if (map.isUnknown(geometry.index(cell)) && !map.options().allow_unknown) {
    return {"The map is unknown at the goal.", true};
  }
  if (map.clearance(goal) < 0.0) {
    const bool inside = map.wallDistance(goal.position()) <= 0.0;
    return {inside ? "The goal is in a wall." : "At the goal the car would touch a wall.", true};
  }
  return {"The lidar sees something at the goal.", false};
}
}  // namespace

Obstruction obstructionOf(const Costmap & costmap, const PlanRequest & request, SearchStatus status)
{
  if (status == SearchStatus::kStartBlocked) {
    return {"The car touches something where it stands.", false};
  }
  Costmap map = costmap;
  map.forgetAll();
  if (status == SearchStatus::kGoalBlocked) {
    return atGoal(map, request.goal);
  }
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
