#pragma once

#include <atomic>
#include <vector>

#include "move_base/map/costmap.h"
#include "move_base/search/arc_price.h"
#include "move_base/search/curves.h"

namespace move_base
{
struct PlannerOptions
{
  double min_turning_radius{0.8};  ///< m, of the base frame's path
  bool allow_reversing{true};      ///< whether plans may drive backwards
  double min_obstacle_dist{0.1};   ///< m, clearance of plans where there is room for it
  int max_expansions{150000};      ///< of all searches for a plan, then it is given up

  /// @throws OptionError
  void validate() const;
  /// That wheels which turn by max_steering_angle, rad, reach the least radius. @throws OptionError
  void requireSteering(double wheelbase, double max_steering_angle) const;
};

enum class SearchStatus
{
  kFound,
  kStartBlocked,  ///< the car at the start overlaps an obstacle
  kGoalBlocked,   ///< the car at the goal would overlap an obstacle
  kUnreachable,
  kBudgetSpent,  ///< max_expansions
};

struct SearchResult
{
  SearchStatus status{SearchStatus::kUnreachable};
  std::vector<Arc> arcs;  ///< from the start to the goal, when found
  int expansions{0};
  double cost{0.0};  ///< in metres of free road, when found
};

/// What the search is to connect.
struct SearchQuery
{
  Pose2 start;
  Pose2 goal;
  double start_curvature{0.0};                 ///< 1/m, how the wheels are set at the start
  int max_expansions{150000};                  ///< then the search is given up
  const std::atomic<bool> * dropped{nullptr};  ///< when it becomes true, the search is given up as well
};

/// Finds drivable ways with hybrid A* (Dolgov et al. 2008): arcs over a grid of positions and headings, led by CostToGo,
/// and closed by Dubins or Reeds-Shepp curves that compete with the rest of the search at their cost.
/// The same query on the same costmap gives the same result, bit for bit.
/// @param rule  of the query's start and goal
SearchResult searchHybridAStar(
  const Costmap & costmap, const PlannerOptions & options, const ShortestCurves & curves, const SearchQuery & query,
  const ClearanceRule & rule);
}  // namespace move_base
