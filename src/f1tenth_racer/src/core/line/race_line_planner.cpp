#include "line/race_line_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "line/path_extension.h"
#include "line/path_smoother.h"
#include "line/race_line.h"
#include "path/goals.h"

namespace f1tenth_racer
{
namespace
{
constexpr double kBeyondPart = 0.05;  // of max_expansions, for the search to the goal beyond

// The search may begin with full lock, and the band keeps the first piece as it is.
void beginAsLed(Path & path, const PlanRequest & request)
{
  if (!request.lead.empty() && path.size() > 2 && !path[1].reverse) {
    path[1].pose = advance(request.start, path[1].s, request.start_curvature);
  }
}
}  // namespace

void RaceLinePlanner::rollOn(const Costmap & costmap, double wanted_length, Way & way) const
{
  const double missing = wanted_length - length(way.arcs);
  const std::vector<Arc> beyond = extensionFrom(way.end, costmap, way.rule, options(), missing);
  way.arcs.insert(way.arcs.end(), beyond.begin(), beyond.end());
}

// What lies beyond a goal may be in the way of a car that passes it exactly.
std::optional<RaceLinePlanner::Way> RaceLinePlanner::wayToNext(
  const Costmap & costmap, const PlanRequest & request, double clearance) const
{
  const RaceLineOptions & gate = *request.race_line;
  const Pose2 & next = gate.goals_beyond.front();
  const int expansions = std::max(1, static_cast<int>(kBeyondPart * options().max_expansions));
  const ClearanceRule rule(costmap, request.start, next, clearance);
  const SearchResult result = search(costmap, request, next, rule, expansions);
  if (result.status != SearchStatus::kFound) {
    return std::nullopt;
  }
  const Path path = samplePath(request.start, result.arcs, kSpacing);
  const PathPoint & passed = path[nearestTo(path, request.goal)];
  const bool passes = distance(passed.pose, request.goal) <= gate.gate_tolerance &&
                      std::abs(normalizeAngle(passed.pose.yaw - request.goal.yaw)) <= gate.gate_yaw_tolerance;
  if (!passes || !isForward(path)) {
    return std::nullopt;
  }
  return Way{result.arcs, rule, next, passed.s};
}

// @return whether it is as long as wanted, or leads to the next goal
bool RaceLinePlanner::goBeyond(const Costmap & costmap, const PlanRequest & request, double clearance, Way & way) const
{
  const double wanted = way.goal_s + request.extension_length;
  rollOn(costmap, wanted, way);
  if (length(way.arcs) >= wanted || !request.race_line || request.race_line->goals_beyond.empty()) {
    return true;
  }
  const std::optional<Way> onward = wayToNext(costmap, request, clearance);
  if (onward && length(onward->arcs) > length(way.arcs)) {
    way = *onward;
    rollOn(costmap, wanted, way);
  }
  return onward.has_value();
}

RaceLinePlanner::Attempt RaceLinePlanner::planWithClearance(
  const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const
{
  const ClearanceRule rule(costmap, request.start, request.goal, clearance);
  const SearchResult result = search(costmap, request, request.goal, rule, max_expansions);
  Plan plan;
  plan.status = result.status;
  plan.expansions = result.expansions;
  if (!plan.found()) {
    return {std::move(plan), false};
  }
  Way way{result.arcs, rule, request.goal, length(result.arcs)};
  const bool forwards = result.arcs.empty() || result.arcs.back().length > 0.0;
  const bool leads_on = !forwards || goBeyond(costmap, request, clearance, way);
  Path path = samplePath(request.start, way.arcs, kSpacing);
  if (!request.race_line) {
    beginAsLed(path, request);  // lines begin so anyway
  }
  const double greatest_curvature = 1.0 / options().min_turning_radius;
  plan.path = smoothPath(path, costmap, way.rule, greatest_curvature, way.goal_s);
  if (request.race_line && isForward(plan.path)) {
    plan.path.front().curvature = request.start_curvature;
    plan.path =
      raceLine(plan.path, costmap, options().min_obstacle_dist, request.goal, greatest_curvature, *request.race_line);
  }
  plan.goal_s = placeOnPath(plan.path, request.goal, way.goal_s);
  prepend(request.lead, plan);
  return {std::move(plan), leads_on};
}
}  // namespace f1tenth_racer
