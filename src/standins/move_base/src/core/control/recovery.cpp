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
constexpr double kProgress = 1.0;        // m from where recovery began
}  // namespace

std::vector<RecoveryBehavior> defaultRecoveries(double conservative_distance, bool may_move)
{
  const std::vector<RecoveryBehavior> behaviors{
    {"conservative_reset", RecoveryBehavior::Kind::kForget, conservative_distance},
    {"aggressive_reset", RecoveryBehavior::Kind::kForget, 0.0}};
  return may_move ? withBackingUp(behaviors) : behaviors;
}

std::vector<RecoveryBehavior> withBackingUp(const std::vector<RecoveryBehavior> & behaviors)
{
  std::vector<RecoveryBehavior> all;
  for (const RecoveryBehavior & behavior : behaviors) {
    all.push_back(behavior);
    all.push_back({"back_up", RecoveryBehavior::Kind::kBackUp});
  }
  return all;
}

const RecoveryBehavior & RecoverySequence::next(const Pose2 & car, RecoveryNotice & notice)
{
  begun_at_ = car;
  const RecoveryBehavior & behavior = behaviors_[index_];
  notice = {static_cast<unsigned>(index_), static_cast<unsigned>(behaviors_.size()), behavior.name};
  ++index_;
  return behavior;
}

void RecoverySequence::noteProgress(const Pose2 & car)
{
  if (index_ > 0 && distance(begun_at_, car) > kProgress) {
    index_ = 0;
  }
}

void OscillationWatch::startAgain(double time)
{
  since_ = time;
  from_.reset();
}

void OscillationWatch::note(const Pose2 & car, double time)
{
  if (!from_ || distance(*from_, car) >= way_) {
    from_ = car;
    since_ = time;
  }
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
