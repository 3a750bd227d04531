#include "move_base/planning/way_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace move_base
{
namespace
{
constexpr double kLeastClearance = 0.02;  // m
constexpr double kNarrower = 0.04;        // m, by which less clearance is tried
constexpr double kFirstPart = 0.4;        // of max_expansions, for the search with the clearance wanted
constexpr double kShortPart = 0.05;       // the same for one with less clearance
constexpr double kClearlyFarther = 1.0;   // m, by which a plan with less clearance must lead farther

int partOf(int max_expansions, double part)
{
  return std::max(1, static_cast<int>(part * max_expansions));
}
}  // namespace

std::vector<double> clearancesFrom(double wanted)
{
  std::vector<double> clearances;
  for (double clearance = wanted; clearance > kLeastClearance + 0.5 * kNarrower; clearance -= kNarrower) {
    clearances.push_back(clearance);
  }
  clearances.push_back(kLeastClearance);
  return clearances;
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

WayPlanner::WayPlanner(const PlannerOptions & options)
: options_(options),
  curves_(options.min_turning_radius, options.allow_reversing),
  clearances_(clearancesFrom(options.min_obstacle_dist))
{
  options_.validate();
}

Plan WayPlanner::makePlan(const Costmap & costmap, const PlanRequest & request) const
{
  const int most = request.max_expansions > 0 ? request.max_expansions : options_.max_expansions;
  Plan best;
  int spent = 0;
  // Narrow gaps make a search long or fail: something must be left for the last one.
  double part = kFirstPart;
  for (const double clearance : clearances_) {
    const bool last = clearance == clearances_.back();
    Attempt attempt =
      planWithClearance(costmap, request, clearance, last ? std::max(1, most - spent) : partOf(most, part));
    part = kShortPart;
    spent += attempt.plan.expansions;
    const bool narrow = attempt.isNarrow();
    if (!best.found() || length(attempt.plan.path) > length(best.path) + kClearlyFarther) {
      best = std::move(attempt.plan);
    }
    if (!narrow) {
      break;
    }
  }
  best.expansions = spent;
  best.races = request.race_line.has_value();
  return best;
}

bool WayPlanner::Attempt::isNarrow() const
{
  return plan.found() ? !leads_on
                      : plan.status == SearchStatus::kUnreachable || plan.status == SearchStatus::kBudgetSpent;
}

SearchResult WayPlanner::search(
  const Costmap & costmap, const PlanRequest & request, const Pose2 & goal, const ClearanceRule & rule,
  int max_expansions) const
{
  const SearchQuery query{request.start, goal, request.start_curvature, max_expansions, request.dropped.get()};
  return searchHybridAStar(costmap, options_, curves_, query, rule);
}

WayPlanner::Attempt WayPlanner::planWithClearance(
  const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const
{
  const ClearanceRule rule(costmap, request.start, request.goal, clearance);
  const SearchResult result = search(costmap, request, request.goal, rule, max_expansions);
  Attempt attempt{{result.status, {}, 0.0, result.expansions}, true};
  Plan & plan = attempt.plan;
  if (plan.found()) {
    plan.path = samplePath(request.start, result.arcs, kSpacing);
    plan.goal_s = length(plan.path);
    prepend(request.lead, plan);
  }
  return attempt;
}
}  // namespace move_base
