#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "control/path_follower.h"
#include "map/costmap.h"

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

/// Which behaviour comes next.
class RecoverySequence
{
public:
  explicit RecoverySequence(std::vector<RecoveryBehavior> behaviors) : behaviors_(std::move(behaviors)) {}

  bool isSpent() const { return index_ >= behaviors_.size(); }
  /// Not to be called when spent.
  /// @param notice  what to say of it
  const RecoveryBehavior & next(const Pose2 & car, RecoveryNotice & notice);
  /// Recovery has helped when the car gets farther than recovery itself has moved it: then it begins anew.
  void noteProgress(const Pose2 & car);
  void startAgain() { index_ = 0; }

private:
  std::vector<RecoveryBehavior> behaviors_;
  std::size_t index_{0};
  Pose2 begun_at_;
};

/// Notices that a car gets nowhere.
class OscillationWatch
{
public:
  /// @param timeout  s; 0: it notices nothing
  /// @param way      m, that the car must get away in that time
  OscillationWatch(double timeout, double way) : timeout_(timeout), way_(way) {}

  void startAgain(double time);
  /// Gives it the whole time once more.
  void wait(double time) { since_ = time; }
  void note(const Pose2 & car, double time);
  bool isOver(double time) const { return timeout_ > 0.0 && time > since_ + timeout_; }

private:
  double timeout_;
  double way_;
  double since_{0.0};
  std::optional<Pose2> from_;
};

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
