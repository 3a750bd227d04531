#include "move_base/recovery/recovery.h"

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

void Recovery::startAgain(double time)
{
  index_ = 0;
  since_ = time;
  from_.reset();
  backing_since_.reset();
}

void Recovery::note(const Pose2 & car, double time)
{
  if (!from_ || distance(*from_, car) >= way_) {
    from_ = car;
    since_ = time;
  }
  if (index_ > 0 && distance(begun_at_, car) > kProgress) {
    index_ = 0;
  }
}

RecoveryNotice Recovery::begin(const Pose2 & car, double time, Costmap & costmap)
{
  const RecoveryBehavior & behavior = behaviors_[index_];
  const RecoveryNotice notice{static_cast<unsigned>(index_), static_cast<unsigned>(behaviors_.size()), behavior.name};
  begun_at_ = car;
  ++index_;
  if (behavior.kind == RecoveryBehavior::Kind::kBackUp) {
    backing_since_ = time;
  } else {
    costmap.forgetBeyond(car.position(), behavior.distance);
    since_ = time;
  }
  return notice;
}

double Recovery::backUp(const Pose2 & car, double time, const Costmap & costmap)
{
  const double behind = costmap.clearance(advance(car, -kLookBehind, 0.0));
  const bool free = behind >= std::min(0.0, costmap.clearance(car) + kClearanceGain);
  if (free && distance(car, begun_at_) < kBackUpDistance && time <= *backing_since_ + kBackUpTime) {
    return -speed_;
  }
  backing_since_.reset();
  since_ = time;
  return 0.0;
}

std::string failureOf(Trigger trigger, const std::string & no_plan_because)
{
  const std::string spent = ". Even after executing recovery behaviors.";
  switch (trigger) {
    case Trigger::kPlanning:
      return "Failed to find a valid plan" + spent + " " + no_plan_because;
    case Trigger::kControlling:
      return "Failed to find a valid control" + spent;
    case Trigger::kOscillation:
      return "Robot is oscillating" + spent;
  }
  return "";
}
}  // namespace move_base
