#pragma once

#include <move_base/search/hybrid_a_star.h>

#include "path/goals.h"
#include "path/terms.h"
#include "tyres/handling.h"

namespace f1tenth_racer
{
/// All that can be chosen of the racer. visitEach() tells name, unit, meaning and range of each, those of the parts included:
/// parameters, Python and the README take them from there.
struct RacerOptions
{
  GoalTolerance goal_tolerance;
  bool free_goal_vel{false};
  GoalTolerance via_tolerance{0.45, 0.6};
  bool race_line{false};
  double coast_time{0.5};
  PlannerOptions planner;  ///< of ways past others, move_base's
  FollowerOptions follower;

  template <class Self, class Visit>
  static void visitEach(Self & self, const Visit & visit)
  {
    FollowerOptions::visitEach(self.follower, visit);
    visit(
      {"xy_goal_tolerance", "m", "within which the car comes to a stop", Option::Range::kPositive},
      self.goal_tolerance.distance);
    visit({"yaw_goal_tolerance", "rad", "the same for its heading", Option::Range::kPositive}, self.goal_tolerance.yaw);
    visit(
      {"free_goal_vel", "", "whether a goal that another one follows is passed at speed", Option::Range::kNotNegative},
      self.free_goal_vel);
    visit(
      {"via_xy_tolerance", "m", "within which such a goal is passed", Option::Range::kPositive},
      self.via_tolerance.distance);
    visit({"via_yaw_tolerance", "rad", "the same for the heading", Option::Range::kPositive}, self.via_tolerance.yaw);
    visit(
      {"race_line", "", "whether plans through such goals, or far from one, use the width of the road",
       Option::Range::kNotNegative},
      self.race_line);
    visit(
      {"coast_time", "s", "for which the car drives on behind such a goal before it brakes",
       Option::Range::kNotNegative},
      self.coast_time);
  }

  /// @throws OptionError
  void validate() const;
};
}  // namespace f1tenth_racer
