#pragma once

#include <move_base/planning/way_planner.h>

#include <optional>
#include <vector>

#include "path/terms.h"

namespace f1tenth_racer
{
/// Hybrid A* whose ways go on beyond the goal, and become race lines where one is asked for. Where the car cannot roll
/// on from the goal, the goal is passed on the way to the next.
class RaceLinePlanner : public WayPlanner
{
public:
  using WayPlanner::WayPlanner;

private:
  struct Way
  {
    std::vector<Arc> arcs;
    ClearanceRule rule;  // that it keeps
    Pose2 end;
    double goal_s;  // m along it
  };

  Attempt planWithClearance(
    const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const override;
  void rollOn(const Costmap & costmap, double wanted_length, Way & way) const;
  std::optional<Way> wayToNext(const Costmap & costmap, const PlanRequest & request, double clearance) const;
  bool goBeyond(const Costmap & costmap, const PlanRequest & request, double clearance, Way & way) const;
};
}  // namespace f1tenth_racer
