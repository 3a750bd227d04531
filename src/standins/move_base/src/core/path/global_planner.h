#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "map/costmap.h"
#include "path/path.h"
#include "search/hybrid_a_star.h"

namespace move_base
{
/// A way to a goal, and, where asked for, beyond it.
struct Plan
{
  SearchStatus status{SearchStatus::kUnreachable};
  Path path;           ///< empty unless found
  double goal_s{0.0};  ///< m along the path, where the goal is
  int expansions{0};   ///< of the searches

  bool found() const { return status == SearchStatus::kFound; }
};

/// How a line uses the width of the road.
struct RaceLineOptions
{
  double gate_tolerance{0.3};         ///< m, how far beside a goal the line may pass
  double gate_yaw_tolerance{0.4};     ///< rad, by which its heading there may differ
  double slip_gradient{0.0};          ///< rad per m/s^2, by which the car's nose points into a bend
  double lateral_acceleration{0.0};   ///< m/s^2, at which bends are driven
  double max_speed{0.0};              ///< m/s
  std::vector<Pose2> goals_beyond{};  ///< that follow the goal, in their order
};

struct PlanRequest
{
  Pose2 start;
  Pose2 goal;
  double start_curvature{0.0};   ///< 1/m, how the wheels are set at the start
  double extension_length{0.0};  ///< m, wanted beyond the goal
  /// For a goal that is passed at speed: make the bends wide instead of keeping to the middle.
  std::optional<RaceLineOptions> race_line{};
  Path lead{};  ///< what leads to the start and is to stay as it is
  /// Set by another thread when the plan is no longer wanted: the search is given up.
  std::shared_ptr<const std::atomic<bool>> dropped{};
};

/// What is tried one after the other, m: the clearance wanted, less, and in the end as little as the map's precision.
std::vector<double> clearancesFrom(double wanted);

/// How far along the path the goal is, m: at its nearest point, among those near to near_s.
double placeOnPath(const Path & path, const Pose2 & goal, double near_s);

/// Puts what leads to the start of a plan's path in front of it.
void prepend(const Path & lead, Plan & plan);

/// Plans paths that the car can drive and that keep to the middle where there is room.
class GlobalPlanner
{
public:
  /// @throws OptionError
  explicit GlobalPlanner(const PlannerOptions & options);

  /// Tries with the clearance of the options, then with less and in the end as little as the map's precision, where
  /// that leads farther. Where the car cannot roll on from the goal, the goal is passed on the way to the next.
  Plan plan(const Costmap & costmap, const PlanRequest & request) const;

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

  int expansions(double part) const;
  void rollOn(const Costmap & costmap, double wanted_length, Way & way) const;
  std::optional<Way> wayToNext(const Costmap & costmap, const PlanRequest & request, double clearance) const;
  bool goBeyond(const Costmap & costmap, const PlanRequest & request, double clearance, Way & way) const;
  Attempt planWithClearance(
    const Costmap & costmap, const PlanRequest & request, double clearance, int max_expansions) const;

  PlannerOptions options_;
  ShortestCurves curves_;
  std::vector<double> clearances_;  // m, one after the other
};
}  // namespace move_base
