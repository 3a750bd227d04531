#pragma once

#include <vector>

#include "control/path_follower.h"
#include "control/recovery.h"
#include "goals.h"
#include "path/global_planner.h"

namespace move_base
{
struct NavigatorOptions
{
  double planner_frequency{0.0};     ///< Hz, plans made anew while driving; 0: only when needed
  double planner_patience{5.0};      ///< s without a plan before recovery
  double controller_patience{15.0};  ///< s without a way to drive on before recovery
  int max_planning_retries{-1};      ///< failed plans before recovery; -1: as many as planner_patience allows
  double oscillation_timeout{0.0};   ///< s within oscillation_distance before recovery; 0: any time
  double oscillation_distance{0.5};  ///< m
  bool recovery_behavior_enabled{true};
  std::vector<RecoveryBehavior> recoveries{defaultRecoveries(3.0, true)};
  GoalTolerance goal_tolerance;            ///< within which the car comes to a stop
  bool free_goal_vel{false};               ///< whether a goal that another one follows is passed at speed
  GoalTolerance via_tolerance{0.45, 0.6};  ///< within which such a goal is passed
  bool race_line{false};                   ///< whether plans through such goals, or far from one, use the road's width
  double coast_time{0.5};                  ///< s, for which the car drives on behind such a goal before it brakes
  PlannerOptions planner;
  FollowerOptions follower;

  /// @throws OptionError
  void validate() const;
};
}  // namespace move_base
