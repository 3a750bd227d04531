#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "move_base/global_planner.h"
#include "move_base/search/arc_price.h"
#include "move_base/search/curves.h"

namespace move_base
{
/// What is tried one after the other, m: the clearance wanted, less, and in the end as little as the map's precision.
std::vector<double> clearancesFrom(double wanted);

/// How far along the path the goal is, m: at its nearest point, among those near to near_s.
double placeOnPath(const Path & path, const Pose2 & goal, double near_s);

/// Puts what leads to the start of a plan's path in front of it.
void prepend(const Path & lead, Plan & plan);

/// Draws the line that a plan with a race line is to be, along a path that is driven forwards.
using LineDrawer = std::function<Path(const Path &, const Costmap &, const PlanRequest &)>;

/// Plans ways that the car can drive and that keep to the middle where there is room: hybrid A*, smoothed.
class WayPlanner : public GlobalPlanner
{
public:
  /// @param draw  empty: plans are never race lines
  /// @throws OptionError
  explicit WayPlanner(const PlannerOptions & options, LineDrawer draw = {});

  /// Tries with the clearance of the options, then with less and in the end as little as the map's precision, where
  /// that leads farther. Where the car cannot roll on from the goal, the goal is passed on the way to the next.
  Plan makePlan(const Costmap & costmap, const PlanRequest & request) const override;

private:
  struct Way
  {
    std::vector<Arc> arcs;
    ClearanceRule rule;  // that it keeps
    Pose2 end;
    double goal_s;  // m along it
  };
  struct Attempt
  {
    bool isNarrow() const;

    Plan plan;
    bool leads_on;  // beyond the goal
  };

  bool draws(const PlanRequest & request) const { return draw_ && request.race_line; }
  void rollOn(const Costmap & costmap, double wanted_length, Way & way) const;
  std::optional<Way> wayToNext(const Costmap & costmap, const PlanRequest & request, double clearance) const;
  bool goBeyond(const Costmap & costmap, const PlanRequest & request, double clearance, Way & way) const;
  Attempt planWithClearance(
    const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const;

  PlannerOptions options_;
  LineDrawer draw_;
  ShortestCurves curves_;
  std::vector<double> clearances_;  // m, one after the other
};
}  // namespace move_base
