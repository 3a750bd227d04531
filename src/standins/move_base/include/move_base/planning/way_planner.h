#pragma once

#include <vector>

#include "move_base/global_planner.h"
#include "move_base/search/arc_price.h"
#include "move_base/search/curves.h"

namespace move_base
{
/// What is tried one after the other, m: the clearance wanted, less, and in the end as little as the map's precision.
std::vector<double> clearancesFrom(double wanted);

/// Puts what leads to the start of a plan's path in front of it.
void prepend(const Path & lead, Plan & plan);

/// Plans ways that the car can drive and that keep to the middle where there is room: hybrid A*.
class WayPlanner : public GlobalPlanner
{
public:
  /// @throws OptionError
  explicit WayPlanner(const PlannerOptions & options);

  /// Tries with the clearance of the options, then with less and in the end as little as the map's precision, where
  /// that leads farther.
  Plan makePlan(const Costmap & costmap, const PlanRequest & request) const override;

protected:
  static constexpr double kSpacing = 0.1;  // m, between points of a path

  struct Attempt
  {
    bool isNarrow() const;

    Plan plan;
    bool leads_on;  // as far as is wanted
  };

  /// A plan with this clearance, m.
  virtual Attempt planWithClearance(
    const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const;
  /// The way from a request's start to a goal.
  SearchResult search(
    const Costmap & costmap, const PlanRequest & request, const Pose2 & goal, const ClearanceRule & rule,
    int max_expansions) const;
  const PlannerOptions & options() const { return options_; }

private:
  PlannerOptions options_;
  ShortestCurves curves_;
  std::vector<double> clearances_;  // m, one after the other
};
}  // namespace move_base
