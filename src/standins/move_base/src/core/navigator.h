#pragma once

#include <optional>
#include <string>
#include <vector>

#include "control/dead_reckoning.h"
#include "control/path_follower.h"
#include "control/recovery.h"
#include "goals.h"
#include "path/global_planner.h"
#include "path/obstruction.h"

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
  bool clearing_rotation_allowed{
    true};  ///< whether recovery may move the car: it backs up, as it cannot turn on the spot
  double conservative_reset_dist{3.0};     ///< m from the car, beyond it the first recovery forgets what the lidar saw
  GoalTolerance goal_tolerance;            ///< within which the car stands in the end
  bool free_goal_vel{false};               ///< whether a goal that another one follows is passed at speed
  GoalTolerance via_tolerance{0.45, 0.6};  ///< within which such a goal is passed
  bool race_line{false};                   ///< whether plans through such goals, or far from one, use the road's width
  double coast_time{0.5};                  ///< s, that the car drives on behind such a goal before it brakes
  PlannerOptions planner;
  FollowerOptions follower;

  /// @throws OptionError
  void validate() const;
};

struct Outcome
{
  bool succeeded{false};
  std::string text;
};

struct RecoveryNotice
{
  unsigned number{0};  ///< from 0
  unsigned total{0};
  std::string name;
};

/// What a control cycle is decided on.
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
/// clock and no threads, and the same inputs give the same commands.
class Navigator
{
public:
  /// @throws OptionError
  explicit Navigator(const NavigatorOptions & options);

  /// Heads for a goal in the map, in place of any other.
  /// @param next  goals that follow it, as far as they are known; the last is the goal itself when they go round.
  ///              Without any the car comes to a stand at the goal.
  void setGoal(const Pose2 & goal, double time, std::vector<Pose2> next = {});
  /// Says anew what follows the goal.
  void setNextGoals(std::vector<Pose2> next);
  /// Drops the goal and stops the car.
  void cancel();
  bool active() const { return goals_.any(); }

  /// One control cycle, to be called with rising time. May change the costmap's live layer (recovery).
  CycleOutput cycle(const CycleInput & input, Costmap & costmap);

  /// The latest plan, empty before the first.
  const Plan & plan() const { return plan_; }
  /// A plan for somebody else; changes nothing here.
  Plan makePlan(const Costmap & costmap, const Pose2 & start, const Pose2 & goal) const;

private:
  enum class State
  {
    kPlanning,
    kControlling,
    kBackingUp
  };
  enum class Trigger
  {
    kPlanning,
    kControlling,
    kOscillation
  };

  void drive(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void driveBlind(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void pursue(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void planAhead(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void planFailed(const Obstruction & obstruction, const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void giveUp(const std::string & text, const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void control(const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void passIfHindered(
    const CycleInput & input, const Costmap & costmap, const std::vector<Forecast> & others, CycleOutput & output);
  void coast(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void hold(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  bool finishIfReached(const CycleInput & input, CycleOutput & output);
  bool needsPlan(const CycleInput & input, const FollowStep & step) const;
  void recover(Trigger trigger, const CycleInput & input, Costmap & costmap, CycleOutput & output);
  void driveBack(const CycleInput & input, const Costmap & costmap, CycleOutput & output);
  void begin(RecoveryBehavior behavior, const CycleInput & input, Costmap & costmap);
  void endRecovery(double time);
  void watchOscillation(const CycleInput & input);
  void watchProgress(const CycleInput & input);
  bool passes() const { return options_.free_goal_vel && goals_.anyNext(); }
  bool races(const CarState & car) const;
  const GoalTolerance & tolerance() const { return passes() ? options_.via_tolerance : options_.goal_tolerance; }
  bool canDrive(const Plan & plan, const CarState & car, const Costmap & costmap) const;
  PlanRequest requestFrom(const CarState & car) const;
  double extensionLength() const;
  double approachLength(double speed) const;
  double period(double time) const;
  void stop();
  std::string failureOf(Trigger trigger) const;

  NavigatorOptions options_;
  GlobalPlanner planner_;
  PathFollower follower_;
  DeadReckoning reckoning_;
  std::vector<RecoveryBehavior> behaviors_;
  Plan plan_;
  bool plan_races_{false};

  Goals goals_;
  State state_{State::kPlanning};
  unsigned recovery_index_{0};
  int planning_retries_{0};
  double last_valid_plan_{0.0};
  double last_valid_control_{0.0};
  double next_plan_{0.0};
  double next_passing_{0.0};
  double last_oscillation_reset_{0.0};
  std::optional<Pose2> oscillation_pose_;
  std::optional<Pose2> previous_pose_;
  std::optional<double> previous_time_;
  std::optional<double> coast_until_;
  double stop_until_{0.0};
  std::optional<BackUp> back_up_;
  Pose2 recovery_pose_;
  std::string no_plan_because_;  // since there was no plan
};
}  // namespace move_base
