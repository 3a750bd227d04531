#pragma once

#include <utility>
#include <vector>

#include "plan_requests.h"
#include "traffic/forecast.h"

namespace move_base
{
/// Where a car is in a moment, and who else drives about.
struct Scene
{
  double time;  ///< s
  const CarState & car;
  const Costmap & costmap;
  const std::vector<Forecast> & others;
};

/// What a car drives along: a plan for its goal, or a way past others that goes over into it.
class Way
{
public:
  /// @param follower  is put on the way
  Way(const NavigatorOptions & options, const PlanRequests & requests, PathFollower & follower)
  : options_(options), requests_(requests), follower_(follower)
  {
  }

  const Plan & plan() const { return plan_; }
  /// Whether it has become another one since this was asked last.
  bool takeChange() { return std::exchange(changed_, false); }

  /// @param races  whether the plan is a race line
  void start(Plan plan, bool races, const Scene & scene);
  /// Looks for a way past others, if they are in the way.
  /// @return whether nobody is in the way any more
  bool passOthers(const Scene & scene);

  /// Whether the car needs another one, after a step along this one.
  /// @param time_needed  s, that a plan may take
  bool isOver(const FollowStep & step, const CarState & car, double time_needed) const;

private:
  void take(Plan plan, const Costmap & costmap);

  const NavigatorOptions & options_;
  const PlanRequests & requests_;
  PathFollower & follower_;
  Plan plan_;
  bool races_{false};
  bool changed_{false};
  double next_look_{0.0};  // s
};
}  // namespace move_base
