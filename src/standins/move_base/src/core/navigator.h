#pragma once

#include <optional>
#include <string>
#include <vector>

#include "control/car_watch.h"
#include "control/path_follower.h"
#include "control/recovery.h"
#include "goals.h"
#include "navigator_options.h"
#include "planning.h"
#include "way.h"

namespace move_base
{
struct Outcome
{
  bool succeeded{false};
  std::string text;
};

/// What a control cycle decides on.
struct CycleInput
{
  double time{0.0};  ///< s
  CarState car;
  bool sensors_current{true};  ///< whether the data are young enough to drive by
  double age{0.0};             ///< s, since the car was at its pose
  double speed_age{0.0};       ///< s, since its speed was measured; counts when the data are too old
};

struct CycleOutput
{
  std::optional<DriveCommand> command;     ///< nothing: not driving
  std::optional<Outcome> outcome;          ///< when the goal has ended
  std::optional<RecoveryNotice> recovery;  ///< when a recovery behaviour has begun
  bool new_plan{false};
  std::string trouble;            ///< why the car does not drive on to its goal, or empty
  std::vector<Pose2> prediction;  ///< where the car is going to be
};

/// Takes a car to goals: plans, follows, recovers and gives up like move_base. Decides on its inputs only: it knows no
/// clock and, without a worker, no threads, and the same inputs give the same commands.
class Navigator
{
public:
  /// @param worker  makes plans while the car drives on along the one that it has; empty: cycle() makes them itself
  /// @throws OptionError
  explicit Navigator(const NavigatorOptions & options, PlanWorker worker = {});
  Navigator(const Navigator &) = delete;
  Navigator & operator=(const Navigator &) = delete;

  /// Heads for a goal in the map, in place of any other.
  /// @param next  goals that follow it, as far as they are known; the last is the goal itself when they form a loop.
  ///              Without any the car comes to a stop at the goal.
  void setGoal(const Pose2 & goal, double time, std::vector<Pose2> next = {});
  /// Replaces the goals that follow the goal.
  void setNextGoals(std::vector<Pose2> next);
  /// Drops the goal and stops the car.
  void cancel();
  bool active() const { return goals_.any(); }
  /// Also while the car comes to a stop behind a goal, or after one that was given up.
  bool drives() const { return goals_.any() || coast_until_; }

  /// One control cycle, to be called with rising time. May change the costmap's live layer (recovery).
  CycleOutput cycle(const CycleInput & input, Costmap & costmap);

  /// The latest plan, empty before the first.
  const Plan & plan() const { return way_.plan(); }

private:
  enum class State
  {
    kPlanning,
    kControlling,
    kBackingUp
  };
  void drive(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void driveBlind(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void pursue(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void planAhead(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void takePlan(PlanAnswer answer, const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void planFailed(const Obstruction & obstruction, const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void giveUp(const std::string & text, const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void control(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  FollowStep follow(const Scene & scene, bool brake, CycleOutput & output);
  void coast(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void hold(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  std::optional<Trigger> whyRecover(double time) const;
  bool finishIfReached(const CycleInput & input, CycleOutput & output);
  void recover(Trigger trigger, const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void driveBack(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void planAgain(double time);
  double period(double time) const;
  void stop();

  NavigatorOptions options_;
  Goals goals_;
  PathFollower follower_;
  PlanRequests requests_;
  Planning planning_;
  Way way_;
  CarWatch car_watch_;
  Recovery recovery_;

  State state_{State::kPlanning};
  double last_valid_control_{0.0};
  std::optional<Pose2> previous_pose_;
  std::optional<double> previous_time_;
  std::optional<double> coast_until_;
  double stop_until_{0.0};
};
}  // namespace move_base
