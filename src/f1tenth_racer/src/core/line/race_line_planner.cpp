#include "line/race_line_planner.h"

#include "line/race_line.h"

namespace f1tenth_racer
{
std::unique_ptr<GlobalPlanner> makeRaceLinePlanner(const PlannerOptions & options)
{
  return std::make_unique<WayPlanner>(
    options, [options](const Path & path, const Costmap & costmap, const PlanRequest & request) {
      return raceLine(
        path, costmap, options.min_obstacle_dist, request.goal, 1.0 / options.min_turning_radius, *request.race_line);
    });
}
}  // namespace f1tenth_racer
