#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "move_base/map/costmap.h"

namespace move_base
{
/// What a car tries when it finds no way.
struct RecoveryBehavior
{
  enum class Kind
  {
    kForget,  ///< forgets what the lidar saw farther away than distance
    kBackUp,  ///< drives straight back a little, as a car cannot turn on the spot
  };
  std::string name;
  Kind kind{Kind::kForget};
  double distance{0.0};  ///< m
};

/// Those of the original, in the order in which they are tried.
/// @param conservative_distance  m
/// @param may_move               whether the car backs up after each
std::vector<RecoveryBehavior> defaultRecoveries(double conservative_distance, bool may_move);
/// The same behaviours, each with backing up after it.
std::vector<RecoveryBehavior> withBackingUp(const std::vector<RecoveryBehavior> & behaviors);

struct RecoveryNotice
{
  unsigned number{0};  ///< from 0
  unsigned total{0};
  std::string name;
};

/// Why a car needs to recover.
enum class Trigger
{
  kPlanning,
  kControlling,
  kOscillation
};

/// What a car that gets nowhere tries, one behaviour after the other.
class Recovery
{
public:
  /// @param timeout  s without getting anywhere; 0: any time
  /// @param way      m, that count as getting somewhere
  /// @param speed    m/s, of backing up
  Recovery(std::vector<RecoveryBehavior> behaviors, double timeout, double way, double speed)
  : behaviors_(std::move(behaviors)), timeout_(timeout), way_(way), speed_(speed)
  {
  }

  /// For a new goal.
  void startAgain(double time);
  /// Where the car is. Recovery has helped when it gets farther than recovery itself has moved it: then it starts over.
  void note(const Pose2 & car, double time);
  /// Nothing before this time, s, counts as getting nowhere: the car was not able to drive.
  void countFrom(double time) { since_ = time; }
  /// Whether it has got nowhere for long.
  bool oscillates(double time) const { return timeout_ > 0.0 && time > since_ + timeout_; }

  bool isSpent() const { return index_ >= behaviors_.size(); }
  /// The next behaviour, not to be called when they are spent: forgets at once, or begins to back up.
  RecoveryNotice begin(const Pose2 & car, double time, Costmap & costmap);
  /// Whether backing up goes on.
  bool backsUp() const { return backing_since_.has_value(); }
  /// The speed, m/s, straight back until far enough, blocked, or too long under way: then 0.
  double backUp(const Pose2 & car, double time, const Costmap & costmap);

private:
  std::vector<RecoveryBehavior> behaviors_;
  double timeout_;
  double way_;
  double speed_;
  std::size_t index_{0};
  Pose2 begun_at_;
  std::optional<double> backing_since_;
  double since_{0.0};
  std::optional<Pose2> from_;
};

/// Says that nothing has helped.
std::string failureOf(Trigger trigger, const std::string & no_plan_because);
}  // namespace move_base
