#include "planning/plan_near.h"

#include <algorithm>
#include <vector>

namespace move_base
{
namespace
{
constexpr double kTryStep = 3.0;  // cells between two tries

// The places of a square around a goal, from its sides' middles outwards.
std::vector<Pose2> squareAround(const Pose2 & goal, double step, int ring)
{
  std::vector<Pose2> places;
  for (int y = 0; y <= ring; ++y) {
    for (int x = y == ring ? 0 : ring; x <= ring; ++x) {
      for (const int up : {-1, 1}) {
        for (const int right : {-1, 1}) {
          if ((y > 0 || up > 0) && (x > 0 || right > 0)) {
            places.push_back({goal.x + right * x * step, goal.y + up * y * step, goal.yaw});
          }
        }
      }
    }
  }
  return places;
}
}  // namespace

Plan planNear(const GlobalPlanner & planner, const Costmap & costmap, const PlanRequest & request, double tolerance)
{
  Plan plan = planner.makePlan(costmap, request);
  const GridGeometry & map = costmap.geometry();
  double step = kTryStep * map.resolution;
  if (tolerance > 0.0) {
    step = std::min(step, tolerance);
  }
  const double across = map.resolution * std::max(map.width, map.height);
  const double farthest = std::min(tolerance * (1.0 + 1e-9), across);  // off the map there is no plan
  int expansions = plan.expansions;
  for (int ring = 1; ring * step <= farthest; ++ring) {
    for (const Pose2 & goal : squareAround(request.goal, step, ring)) {
      if (plan.found() || expansions >= request.max_expansions) {
        return plan;
      }
      PlanRequest elsewhere = request;
      elsewhere.goal = goal;
      elsewhere.max_expansions -= expansions;
      plan = planner.makePlan(costmap, elsewhere);
      expansions += plan.expansions;
    }
  }
  return plan;
}
}  // namespace move_base
