#pragma once

#include <utility>
#include <vector>

#include "path/plan_job.h"
#include "plan_requests.h"
#include "traffic/forecast.h"

namespace move_base
{
/// Where a car is at a moment, and what else drives about.
struct Scene
{
  double time;  ///< s
  const CarState & car;
  const Costmap & costmap;
  const std::vector<Forecast> & others;
};

/// What a car drives along: a plan for its goal, or a way past others that leads into it.
class Way
{
public:
  /// @param follower  is put on the way
  Way(const NavigatorOptions & options, Goals & goals, const PlanRequests & requests, PathFollower & follower)
  : options_(options), goals_(goals), requests_(requests), follower_(follower)
  {
  }

  const Plan & plan() const { return plan_; }
  /// Whether it has been replaced since the last call.
  bool takeChange() { return std::exchange(changed_, false); }

  enum class Renewal
  {
    kRefused,  ///< the car cannot switch to the plan
    kKept,     ///< others would be in the way on it, but are not on what the car drives along
    kStarted
  };
  /// Switches to a plan, or to a way past others on it. Plans know nothing of others that drive about: a way past them
  /// is not left for one on which they are in the way.
  Renewal renew(PlanAnswer answer, const Scene & scene);
  /// Moves a goal that is only passed to the side when something stands on it.
  /// @param status  of the plan to it
  void makeRoom(SearchStatus status, const Costmap & costmap);
  /// Looks for a way past others, if they are in the way.
  /// @return whether nobody is in the way any longer
  bool passOthers(const Scene & scene);

  /// Whether the car needs another one, after a step along this one.
  /// @param time_needed  s, that a plan may take
  bool isOver(const FollowStep & step, const CarState & car, double time_needed) const;

private:
  void start(PlanAnswer answer, const Scene & scene);
  void take(Plan plan, const Costmap & costmap, const Caution & caution);
  bool leadsPastOthers(const Scene & scene) const;
  bool goOver(PlanAnswer answer, const Scene & scene);
  void keep(const Scene & scene);
  bool moveGoalHere();

  const NavigatorOptions & options_;
  Goals & goals_;
  const PlanRequests & requests_;
  PathFollower & follower_;
  Plan plan_;
  bool races_{false};
  bool changed_{false};
  double next_look_{0.0};  // s
};
}  // namespace move_base
