#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "move_base/local_planner.h"
#include "move_base/planning/navigator_options.h"
#include "move_base/planning/planning.h"
#include "move_base/recovery/recovery.h"

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
  Navigator(
    const NavigatorOptions & options, std::unique_ptr<GlobalPlanner> global, std::unique_ptr<LocalPlanner> local,
    PlanWorker worker = {});
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
  bool active() const { return active_; }
  /// Also while the car comes to a stop behind a goal, or after one that was given up.
  bool drives() const { return active_ || local_->drivesOn(); }

  /// Takes a scan into the costmap.
  void observe(const LaserScan & scan, Costmap & costmap) { local_->observe(scan, costmap); }
  /// One control cycle, to be called with rising time. May change the costmap's live layer (recovery).
  CycleOutput cycle(const CycleInput & input, Costmap & costmap);

  /// What the car drives along, empty before the first plan.
  const Path & way() const { return local_->way(); }
  const GlobalPlanner & globalPlanner() const { return *global_; }

private:
  enum class State
  {
    kPlanning,
    kControlling,
    kBackingUp
  };
  void drive(bool sensors_current, const Situation & now, Costmap & costmap, CycleOutput & output);
  void driveBlind(const Situation & now, CycleOutput & output);
  void pursue(const Situation & now, Costmap & costmap, CycleOutput & output);
  void planAhead(const Situation & now, Costmap & costmap, CycleOutput & output);
  void takePlan(PlanAnswer answer, const Situation & now, Costmap & costmap, CycleOutput & output);
  void planFailed(const Obstruction & obstruction, const Situation & now, Costmap & costmap, CycleOutput & output);
  void giveUp(const std::string & text, const Situation & now, CycleOutput & output);
  void control(const Situation & now, Costmap & costmap, CycleOutput & output);
  LocalStep follow(const Situation & now, Manner manner, CycleOutput & output);
  void coast(const Situation & now, CycleOutput & output);
  std::optional<Trigger> whyRecover(double time) const;
  bool finishIfReached(const Situation & now, CycleOutput & output);
  void end(const Outcome & outcome, double time, CycleOutput & output);
  void recover(Trigger trigger, const Situation & now, Costmap & costmap, CycleOutput & output);
  void driveBack(const Situation & now, CycleOutput & output);
  void planAgain(double time);
  void stop();

  NavigatorOptions options_;
  std::unique_ptr<GlobalPlanner> global_;
  std::unique_ptr<LocalPlanner> local_;
  Planning planning_;
  Recovery recovery_;

  bool active_{false};
  State state_{State::kPlanning};
  double last_valid_control_{0.0};
  std::optional<double> previous_time_;
  double stop_until_{0.0};
};
}  // namespace move_base
