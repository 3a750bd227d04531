#pragma once

#include <optional>
#include <vector>

#include "control/path_follower.h"
#include "map/costmap.h"

namespace move_base
{
/// What a car tries when it finds no way, in the names of the original where it has them.
enum class RecoveryBehavior
{
  kConservativeReset,  ///< forgets what the lidar saw far away
  kBackUp,             ///< drives straight back a little, as a car cannot turn on the spot
  kAggressiveReset,    ///< forgets everything that the lidar saw
};

const char * nameOf(RecoveryBehavior behavior);

/// The behaviours in the order in which they are tried.
std::vector<RecoveryBehavior> recoveryBehaviors(bool may_move);

/// Driving straight back until far enough, blocked, or too long under way.
class BackUp
{
public:
  /// @param time  s
  BackUp(const Pose2 & start, double time) : start_(start), start_time_(time) {}

  /// @param speed  m/s, above 0
  /// @return nothing when it is over
  std::optional<DriveCommand> step(const Pose2 & pose, double time, double speed, const Costmap & costmap) const;

private:
  Pose2 start_;
  double start_time_;
};
}  // namespace move_base
