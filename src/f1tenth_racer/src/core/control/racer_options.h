#pragma once

#include <move_base/search/hybrid_a_star.h>

#include "path/goals.h"
#include "path/terms.h"
#include "tyres/handling.h"

namespace f1tenth_racer
{
struct RacerOptions
{
  GoalTolerance goal_tolerance;            ///< within which the car comes to a stop
  bool free_goal_vel{false};               ///< whether a goal that another one follows is passed at speed
  GoalTolerance via_tolerance{0.45, 0.6};  ///< within which such a goal is passed
  bool race_line{false};                   ///< whether plans through such goals, or far from one, use the road's width
  double coast_time{0.5};                  ///< s, for which the car drives on behind such a goal before it brakes
  PlannerOptions planner;                  ///< of ways past others
  FollowerOptions follower;

  /// @throws OptionError
  void validate() const;
};
}  // namespace f1tenth_racer
