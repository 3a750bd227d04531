#include "move_base/planning/way_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "path/path_extension.h"
#include "path/path_smoother.h"

namespace move_base
{
namespace
{
constexpr double kSpacing = 0.1;          // m, between points of a path
constexpr double kLeastClearance = 0.02;  // m
constexpr double kNarrower = 0.04;        // m, by which less clearance is tried
constexpr double kFirstPart = 0.4;        // of max_expansions, for the search with the clearance wanted
constexpr double kShortPart = 0.05;       // the same for one with less clearance, or to the goal beyond
constexpr double kClearlyFarther = 1.0;   // m, by which a plan with less clearance must lead farther

// The search may begin with full lock, and the band keeps the first piece as it is.
void beginAsLed(Path & path, const PlanRequest & request)
{
  if (!request.lead.empty() && path.size() > 2 && !path[1].reverse) {
    path[1].pose = advance(request.start, path[1].s, request.start_curvature);
  }
}

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

WayPlanner::WayPlanner(const PlannerOptions & options, LineDrawer draw)
: options_(options),
  draw_(std::move(draw)),
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

void WayPlanner::rollOn(const Costmap & costmap, double wanted_length, Way & way) const
{
  const double missing = wanted_length - length(way.arcs);
  const std::vector<Arc> beyond = extensionFrom(way.end, costmap, way.rule, options_, missing);
  way.arcs.insert(way.arcs.end(), beyond.begin(), beyond.end());
}

// What lies beyond a goal may be in the way of a car that passes it exactly.
std::optional<WayPlanner::Way> WayPlanner::wayToNext(
  const Costmap & costmap, const PlanRequest & request, double clearance) const
{
  const RaceLineOptions & gate = *request.race_line;
  const Pose2 & next = gate.goals_beyond.front();
  const SearchQuery query{
    request.start, next, request.start_curvature, partOf(options_.max_expansions, kShortPart), request.dropped.get()};
  const ClearanceRule rule(costmap, request.start, next, clearance);
  const SearchResult result = searchHybridAStar(costmap, options_, curves_, query, rule);
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
bool WayPlanner::goBeyond(const Costmap & costmap, const PlanRequest & request, double clearance, Way & way) const
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

WayPlanner::Attempt WayPlanner::planWithClearance(
  const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const
{
  const SearchQuery query{request.start, request.goal, request.start_curvature, max_expansions, request.dropped.get()};
  const ClearanceRule rule(costmap, request.start, request.goal, clearance);
  const SearchResult result = searchHybridAStar(costmap, options_, curves_, query, rule);
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
  if (!draws(request)) {
    beginAsLed(path, request);  // lines begin so anyway
  }
  plan.path = smoothPath(path, costmap, way.rule, 1.0 / options_.min_turning_radius, way.goal_s);
  if (draws(request) && isForward(plan.path)) {
    plan.path.front().curvature = request.start_curvature;
    plan.path = draw_(plan.path, costmap, request);
  }
  plan.goal_s = placeOnPath(plan.path, request.goal, way.goal_s);
  prepend(request.lead, plan);
  return {std::move(plan), leads_on};
}
}  // namespace move_base
