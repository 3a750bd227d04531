#include "control/recovery.h"

#include <algorithm>

namespace move_base
{
namespace
{
constexpr double kBackUpDistance = 0.5;  // m
constexpr double kBackUpTime = 5.0;      // s
constexpr double kLookBehind = 0.15;     // m that must be free, or freer than where the car stands
constexpr double kClearanceGain = 0.01;  // m
}  // namespace

const char * nameOf(RecoveryBehavior behavior)
{
  switch (behavior) {
    case RecoveryBehavior::kConservativeReset:
      return "conservative_reset";
    case RecoveryBehavior::kBackUp:
      return "back_up";
    case RecoveryBehavior::kAggressiveReset:
      return "aggressive_reset";
  }
  return "";
}

std::vector<RecoveryBehavior> recoveryBehaviors(bool may_move)
{
  if (!may_move) {
    return {RecoveryBehavior::kConservativeReset, RecoveryBehavior::kAggressiveReset};
  }
  return {
    RecoveryBehavior::kConservativeReset, RecoveryBehavior::kBackUp, RecoveryBehavior::kAggressiveReset,
    RecoveryBehavior::kBackUp};
}

std::optional<DriveCommand> BackUp::step(const Pose2 & pose, double time, double speed, const Costmap & costmap) const
{
  const double behind = costmap.clearance(advance(pose, -kLookBehind, 0.0));
  const bool free = behind >= std::min(0.0, costmap.clearance(pose) + kClearanceGain);
  if (!free || distance(pose, start_) >= kBackUpDistance || time > start_time_ + kBackUpTime) {
    return std::nullopt;
  }
  return DriveCommand{-speed, 0.0};
}
}  // namespace move_base
