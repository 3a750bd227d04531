#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "move_base/map/costmap.h"
#include "move_base/path/path.h"
#include "move_base/search/hybrid_a_star.h"

namespace workspace_support
{
class ParameterReader;
}  // namespace workspace_support

namespace move_base
{
/// A way to a goal, and, where asked for, beyond it.
struct Plan
{
  SearchStatus status{SearchStatus::kUnreachable};
  Path path;           ///< empty unless found
  double goal_s{0.0};  ///< m along the path, where the goal is
  int expansions{0};   ///< of the searches
  bool races{false};   ///< whether a race line was asked for

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

/// What a local planner asks of the global one.
struct PlanRequest
{
  Pose2 start;
  Pose2 goal;
  double start_curvature{0.0};   ///< 1/m, how the wheels are set at the start
  double extension_length{0.0};  ///< m, wanted beyond the goal; the plain planner ends there
  /// For a goal that is passed at speed: make the bends wide instead of keeping to the middle. A planner without race
  /// lines leads past the goals all the same.
  std::optional<RaceLineOptions> race_line{};
  Path lead{};            ///< what leads to the start and is to stay as it is
  double lead_time{0.0};  ///< s, for which the car may drive on along what it drives along, until the plan is there
  int max_expansions{0};  ///< of all searches; 0: what the planner is set to
  /// Set by another thread when the plan is no longer wanted: the search is given up.
  std::shared_ptr<const std::atomic<bool>> dropped{};
};

/// Makes plans, after nav_core::BaseGlobalPlanner.
class GlobalPlanner
{
public:
  GlobalPlanner() = default;
  GlobalPlanner(const GlobalPlanner &) = delete;
  GlobalPlanner & operator=(const GlobalPlanner &) = delete;
  virtual ~GlobalPlanner() = default;

  /// The same request on the same costmap gives the same plan. May be called on any thread, also on several at once.
  virtual Plan makePlan(const Costmap & costmap, const PlanRequest & request) const = 0;
};

/// What a planner is made with.
struct PlannerSetup
{
  std::string global_planner;                       ///< namespace of the global planner's parameters, "NavfnROS"
  std::string local_planner;                        ///< the same of the local planner
  workspace_support::ParameterReader & parameters;  ///< of move_base
};

/// What a library registers, by CLASS_LOADER_REGISTER_CLASS(PACKAGE::CLASS, move_base::GlobalPlannerPlugin), to be chosen
/// as base_global_planner: PACKAGE/CLASS. The library is libPACKAGE_planners.so.
class GlobalPlannerPlugin
{
public:
  virtual ~GlobalPlannerPlugin() = default;
  /// @throws OptionError for a parameter that cannot be used
  virtual std::unique_ptr<GlobalPlanner> create(const PlannerSetup & setup) const = 0;
};
}  // namespace move_base
