#include "move_base/search/hybrid_a_star.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <queue>

#include "move_base/search/arc_price.h"
#include "search/cost_to_go.h"
#include "search/search_nodes.h"

namespace move_base
{
namespace
{
constexpr double kArcLength = 0.3;
constexpr std::array<double, 7> kSteering{-1.0, -0.5, -0.2, 0.0, 0.2, 0.5, 1.0};  // parts of the greatest curvature
// Prices, in metres of free road forwards: of a metre backwards, of a change of driving direction, of steering from straight
// to the limit, and of a metre at the least radius on top.
constexpr double kReversePrice = 2.0;
constexpr double kDirectionPrice = 1.0;
constexpr double kSteeringPrice = 0.05;
constexpr double kBendPrice = 0.1;
// Within this many least radii of the goal, the length of the shortest curve tells more than the way of a point does.
constexpr double kCurveRadii = 5.0;
// Distance from the goal beyond which no curves are tried, m.
constexpr double kCurveRange = 6.0;
// Expansions between two curves tried, per metre from the goal.
constexpr double kCurveInterval = 3.0;

// Weight of what is still to be driven: a plan costs at most this much more than the best one, and takes a fraction of
// the time to find, because every way that keeps to the middle of the road is nearly as good as the others.
constexpr double kGreed = 1.4;

// Where the road may be closed behind the car: so far behind its base frame, and no wider than this to either side, m.
constexpr double kGateBehind = 0.3;
constexpr double kGateReach = 2.5;
constexpr double kGateStep = 0.05;
// Expansions that the search with the road closed behind the car may take; the others find a lap's way with a tenth.
constexpr int kAheadExpansions = 10000;

class Search
{
public:
  Search(
    const Costmap & costmap, const PlannerOptions & options, const ShortestCurves & curves, const SearchQuery & query,
    const ClearanceRule & rule, CostToGo & cost_to_go)
  : costmap_(costmap),
    options_(options),
    curves_(curves),
    query_(query),
    rule_(rule),
    cost_to_go_(cost_to_go),
    nodes_(costmap.geometry().origin)
  {
  }

  SearchResult run()
  {
    open({query_.start, 0.0, -1, {0.0, query_.start_curvature}, false, false});
    return searchGoal();
  }

private:
  struct Entry
  {
    double estimate;
    int node;
    bool operator>(const Entry & other) const
    {
      return estimate != other.estimate ? estimate > other.estimate : node > other.node;
    }
  };

  SearchResult searchGoal()
  {
    int expansions = 0;
    while (!open_.empty()) {
      const int index = open_.top().node;
      open_.pop();
      if (nodes_[index].at_goal) {
        return {SearchStatus::kFound, arcsTo(index), expansions, nodes_[index].cost};
      }
      if (nodes_[index].closed) {
        continue;
      }
      if (++expansions > query_.max_expansions || (query_.dropped != nullptr && *query_.dropped)) {
        return {SearchStatus::kBudgetSpent, {}, expansions};
      }
      nodes_[index].closed = true;
      tryCurve(index);
      expand(index);
    }
    return {SearchStatus::kUnreachable, {}, expansions};
  }

  double estimateFrom(const Pose2 & pose)
  {
    const double way = cost_to_go_.at(pose.position());
    if (distance(pose, query_.goal) > kCurveRadii * options_.min_turning_radius) {
      return way;
    }
    return std::max(way, curves_.length(pose, query_.goal));
  }

  void open(const SearchNode & node)
  {
    int & bin = nodes_.binOf(node.pose);
    if (bin >= 0 && (nodes_[bin].closed || nodes_[bin].cost <= node.cost)) {
      return;
    }
    const double estimate = node.cost + kGreed * estimateFrom(node.pose);
    if (estimate < std::numeric_limits<double>::infinity()) {
      if (bin >= 0) {
        nodes_[bin].closed = true;
      }
      bin = nodes_.add(node);
      open_.push({estimate, bin});
    }
  }

  void expand(int index)
  {
    const SearchNode from = nodes_[index];
    for (const double direction : {1.0, -1.0}) {
      if (direction < 0.0 && !options_.allow_reversing) {
        continue;
      }
      for (const double steering : kSteering) {
        const Arc arc{direction * kArcLength, steering / options_.min_turning_radius};
        const double price = priceOf(costmap_, rule_, from.pose, arc);
        if (price < std::numeric_limits<double>::infinity()) {
          const Pose2 pose = advance(from.pose, arc.length, arc.curvature);
          open({pose, from.cost + weighted(price, from.arc, arc), index, arc, false, false});
        }
      }
    }
  }

  double weighted(double price, const Arc & before, const Arc & arc) const
  {
    const double radius = options_.min_turning_radius;
    double cost = arc.length < 0.0 ? kReversePrice * price : price;
    cost += kBendPrice * std::abs(arc.length * arc.curvature) * radius;
    cost += kSteeringPrice * std::abs(arc.curvature - before.curvature) * radius;
    return before.length * arc.length < 0.0 ? cost + kDirectionPrice : cost;
  }

  void tryCurve(int index)
  {
    const SearchNode & from = nodes_[index];
    const double away = distance(from.pose, query_.goal);
    if (away > kCurveRange || --expansions_to_curve_ > 0) {
      return;
    }
    expansions_to_curve_ = static_cast<int>(kCurveInterval * away);
    SearchNode reached{query_.goal, from.cost, index, from.arc, false, true};
    Pose2 pose = from.pose;
    for (const Arc & arc : curves_.arcs(from.pose, query_.goal)) {
      reached.cost += weighted(priceOf(costmap_, rule_, pose, arc), reached.arc, arc);
      reached.arc = arc;
      pose = advance(pose, arc.length, arc.curvature);
    }
    if (reached.cost < std::numeric_limits<double>::infinity()) {
      open_.push({reached.cost, nodes_.add(reached)});
    }
  }

  std::vector<Arc> arcsTo(int goal) const
  {
    const int last = nodes_[goal].parent;
    std::vector<Arc> arcs = curves_.arcs(nodes_[last].pose, query_.goal);
    for (int index = last; nodes_[index].parent >= 0; index = nodes_[index].parent) {
      arcs.insert(arcs.begin(), nodes_[index].arc);
    }
    return arcs;
  }

  const Costmap & costmap_;
  const PlannerOptions & options_;
  const ShortestCurves & curves_;
  const SearchQuery & query_;
  const ClearanceRule & rule_;
  CostToGo & cost_to_go_;
  SearchNodes nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  int expansions_to_curve_{0};
};

// How far a point can go from another in a direction until it meets a wall; nothing where there is none within reach.
std::optional<double> wayToWall(const Costmap & costmap, const Pose2 & from)
{
  for (double way = 0.0; way <= kGateReach; way += kGateStep) {
    if (costmap.obstacleDistance(advance(from, way, 0.0).position()) < kPointClearance) {
      return way;
    }
  }
  return std::nullopt;
}

// A bar across the road behind the car, from wall to wall.
std::optional<Gate> gateBehind(const Costmap & costmap, const Pose2 & start)
{
  const Pose2 behind = advance(start, -kGateBehind, 0.0);
  const auto left = wayToWall(costmap, {behind.x, behind.y, behind.yaw + M_PI_2});
  const auto right = wayToWall(costmap, {behind.x, behind.y, behind.yaw - M_PI_2});
  if (!left || !right) {
    return std::nullopt;
  }
  return Gate{transform(behind, {0.0, *left}), transform(behind, {0.0, -*right})};
}

// A point's shortest way may lead back from where the car stands, though it takes a car longer to turn around than to
// go the other way around the circuit. Led by that, the search would try all that can be done near the start first: so
// it is done with the road closed behind the car, where that is no worse than kGreed allows.
SearchResult searchAhead(
  const Costmap & costmap, const PlannerOptions & options, const ShortestCurves & curves, const SearchQuery & query,
  const ClearanceRule & rule, double shortest)
{
  const std::optional<Gate> gate = gateBehind(costmap, query.start);
  if (!gate) {
    return {};
  }
  CostToGo way(costmap, query.goal.position(), gate);
  const Pose2 & start = query.start;
  const double turn = curves.length(start, {start.x, start.y, normalizeAngle(start.yaw + M_PI)});
  const double most = kGreed * (shortest + turn);
  if (!(way.at(start.position()) <= most)) {
    return {};
  }
  SearchQuery ahead = query;
  ahead.max_expansions = std::min(query.max_expansions, kAheadExpansions);
  SearchResult result = Search(costmap, options, curves, ahead, rule, way).run();
  if (result.status == SearchStatus::kFound && result.cost > most) {
    result.status = SearchStatus::kUnreachable;
  }
  return result;
}
}  // namespace

void PlannerOptions::validate() const
{
  requirePositive("min_turning_radius", min_turning_radius);
  requireNotNegative("min_obstacle_dist", min_obstacle_dist);
  requireOption(max_expansions > 0, "max_expansions", max_expansions, "above 0");
}

void PlannerOptions::requireSteering(double wheelbase, double max_steering_angle) const
{
  constexpr double kRounding = 1e-9;  // the angle may have been taken from this radius
  const double least = wheelbase / maths::tan(max_steering_angle);
  requireOption(
    min_turning_radius >= (1.0 - kRounding) * least, "min_turning_radius", min_turning_radius,
    "at least wheelbase / tan(max_steering_angle) = " + std::to_string(least));
}

SearchResult searchHybridAStar(
  const Costmap & costmap, const PlannerOptions & options, const ShortestCurves & curves, const SearchQuery & query,
  const ClearanceRule & rule)
{
  if (rule.startClearance() < 0.0) {
    return {SearchStatus::kStartBlocked, {}, 0};
  }
  if (rule.goalClearance() < 0.0) {
    return {SearchStatus::kGoalBlocked, {}, 0};
  }
  CostToGo way(costmap, query.goal.position());
  const double shortest = way.at(query.start.position());
  SearchQuery rest = query;
  if (way.at(advance(query.start, kArcLength, 0.0).position()) > shortest) {
    SearchResult ahead = searchAhead(costmap, options, curves, query, rule, shortest);
    if (ahead.status == SearchStatus::kFound) {
      return ahead;
    }
    rest.max_expansions = std::max(1, query.max_expansions - ahead.expansions);
  }
  SearchResult result = Search(costmap, options, curves, rest, rule, way).run();
  result.expansions += query.max_expansions - rest.max_expansions;
  return result;
}
}  // namespace move_base
