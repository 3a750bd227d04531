#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <move_base/local_planner.h>
#include "control/plan_requests.h"
#include "path/terms.h"
#include "traffic/forecast.h"
#include "traffic/passing.h"

namespace f1tenth_racer
{
/// Where a car is at a moment, and what else drives about.
struct Scene
{
  double time;  ///< s
  const CarState & car;
  const Costmap & costmap;
  std::vector<Forecast> others;
};

/// What a car drives along: a plan for its goal, or a way past others that leads into it.
class Way
{
public:
  /// @param follower  is put on the way
  Way(const RacerOptions & options, Goals & goals, const PlanRequests & requests, PathFollower & follower)
  : options_(options), goals_(goals), requests_(requests), follower_(follower)
  {
  }

  const Plan & plan() const { return plan_; }
  /// Whether it has been replaced since the last call.
  bool takeChange() { return std::exchange(changed_, false); }

  /// Switches to a plan, or to a way past others on it. Plans know nothing of others that drive about: a way past them
  /// is not left for one on which they are in the way.
  LocalPlanner::Reception renew(Plan plan, const Scene & scene);
  /// Moves a goal that is only passed to the side when something stands on it.
  /// @param status  of the plan to it
  /// @return whether it has been moved
  bool makeRoom(SearchStatus status, const Costmap & costmap);
  /// Looks for a way past others, if they are in the way.
  void passOthers(const Scene & scene);

  /// Whether the car needs another one, after a step along this one.
  /// @param time_needed  s, that a plan may take
  bool isOver(const FollowStep & step, const CarState & car, double time_needed) const;

private:
  void start(Plan plan, const Scene & scene);
  void take(Plan plan, const Costmap & costmap, const Caution & caution);
  bool leadsPastOthers(const Scene & scene) const;
  bool goOver(Plan plan, const Scene & scene);
  std::optional<PassingPlan> lookPast(const Plan & plan, const PathFollower & follower, const Scene & scene);
  void swingOut(PassingPlan past, const Costmap & costmap);
  void keep(const Scene & scene);
  bool moveGoalHere();

  const RacerOptions & options_;
  Goals & goals_;
  const PlanRequests & requests_;
  PathFollower & follower_;
  Plan plan_;
  bool races_{false};
  bool changed_{false};
  double next_look_{0.0};  // s
};
}  // namespace f1tenth_racer
