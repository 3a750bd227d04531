#pragma once

#include <vector>

#include "move_base/recovery/recovery.h"

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
  double backing_speed{0.2};  ///< m/s, of recovery

  /// @throws OptionError
  void validate() const;
};
}  // namespace move_base
