#include "path/global_planner.h"

#include <algorithm>

#include "path/path_extension.h"
#include "path/path_smoother.h"
#include "path/race_line.h"

namespace move_base
{
namespace
{
constexpr double kSpacing = 0.1;          // m, between points of a path
constexpr double kLeastClearance = 0.02;  // m
constexpr double kFirstPart = 0.4;        // of max_expansions, for the search with the clearance wanted
}  // namespace

double placeOnPath(const Path & path, const Pose2 & goal, double near_s)
{
  const auto off = [&](const PathPoint & point) {
    return distance(point.pose, goal) + 0.01 * std::abs(point.s - near_s);
  };
  const auto nearest = std::min_element(
    path.begin(), path.end(), [&](const PathPoint & a, const PathPoint & b) { return off(a) < off(b); });
  return nearest->s;
}

void prepend(const Path & lead, Plan & plan)
{
  if (lead.empty()) {
    return;
  }
  const double shift = length(lead) - plan.path.front().s;
  Path path = lead;
  const double start_s = lead.front().s;
  for (PathPoint & point : path) {
    point.s -= start_s;
  }
  if (!plan.path.front().reverse) {
    path.pop_back();
  }
  for (PathPoint & point : plan.path) {
    point.s += shift;
    path.push_back(point);
  }
  plan.path = std::move(path);
  plan.goal_s += shift;
}

GlobalPlanner::GlobalPlanner(const PlannerOptions & options)
: options_(options), curves_(options.min_turning_radius, options.allow_reversing)
{
  options_.validate();
}

Plan GlobalPlanner::plan(const Costmap & costmap, const PlanRequest & request) const
{
  if (options_.min_obstacle_dist <= kLeastClearance) {
    return planWithClearance(costmap, request, kLeastClearance, options_.max_expansions);
  }
  // Narrow gaps make the first search long or fail: something must be left for the second one.
  const int first_budget = std::max(1, static_cast<int>(kFirstPart * options_.max_expansions));
  const Plan wanted = planWithClearance(costmap, request, options_.min_obstacle_dist, first_budget);
  if (wanted.status != SearchStatus::kUnreachable && wanted.status != SearchStatus::kBudgetSpent) {
    return wanted;
  }
  const int left = std::max(1, options_.max_expansions - wanted.expansions);
  Plan narrow = planWithClearance(costmap, request, kLeastClearance, left);
  narrow.expansions += wanted.expansions;
  return narrow;
}

Plan GlobalPlanner::planWithClearance(
  const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const
{
  const SearchQuery query{request.start, request.goal, request.start_curvature, max_expansions, request.dropped.get()};
  const ClearanceRule rule(costmap, request.start, request.goal, clearance);
  SearchResult result = searchHybridAStar(costmap, options_, curves_, query, rule);
  Plan plan;
  plan.status = result.status;
  plan.expansions = result.expansions;
  if (!plan.found()) {
    return plan;
  }
  const double goal_s = length(result.arcs);
  if (result.arcs.empty() || result.arcs.back().length > 0.0) {
    const std::vector<Arc> beyond = extensionFrom(request.goal, costmap, rule, options_, request.extension_length);
    result.arcs.insert(result.arcs.end(), beyond.begin(), beyond.end());
  }
  const Path path = samplePath(request.start, result.arcs, kSpacing);
  plan.path = smoothPath(path, costmap, rule, 1.0 / options_.min_turning_radius, goal_s);
  if (request.race_line && isForward(plan.path)) {
    plan.path.front().curvature = request.start_curvature;
    plan.path = raceLine(
      plan.path, costmap, options_.min_obstacle_dist, request.goal, 1.0 / options_.min_turning_radius,
      *request.race_line);
  }
  plan.goal_s = placeOnPath(plan.path, request.goal, goal_s);
  prepend(request.lead, plan);
  return plan;
}
}  // namespace move_base
