#pragma once

#include <memory>
#include <vector>

#include "move_base/car.h"
#include "move_base/global_planner.h"

namespace move_base
{
/// Where a car is at a control cycle.
struct Situation
{
  double time;  ///< s
  CarState car;
  const Costmap & costmap;
  double plan_time{0.0};  ///< s, that a plan may take while the car drives on
};

/// How a car is to be driven on.
enum class Manner
{
  kFree,     ///< as the planner likes
  kKeepWay,  ///< along the way that it is on: a plan that leads on from there is being made
  kBrake     ///< to a standstill along that way, or at once without one
};

/// One control cycle of a local planner.
struct LocalStep
{
  DriveCommand command;
  bool lost{false};                 ///< the car is off its way
  bool stuck{false};                ///< it cannot drive on without touching something
  bool wants_plan{false};           ///< whether it needs another plan
  bool new_way{false};              ///< whether the way has been replaced since the last cycle
  std::vector<Pose2> prediction{};  ///< where the car is going to be
};

/// Drives a car along plans, after nav_core::BaseLocalPlanner. Knows no clock: the same calls give the same commands.
/// In each cycle update() comes first and noteCommand() last.
class LocalPlanner
{
public:
  LocalPlanner() = default;
  LocalPlanner(const LocalPlanner &) = delete;
  LocalPlanner & operator=(const LocalPlanner &) = delete;
  virtual ~LocalPlanner() = default;

  /// Takes a scan into the costmap.
  virtual void observe(const LaserScan & scan, Costmap & costmap) { costmap.observe(scan); }

  /// Begins a cycle.
  /// @param now  s; less than before when time has jumped back
  /// @return the car's motion now
  virtual CarState update(const CarSighting & sighting, double now, const Costmap & costmap) = 0;
  /// Ends a cycle.
  /// @param command  what was sent, by whomever; zero for nothing
  virtual void noteCommand(double time, const DriveCommand & command) = 0;

  /// Heads for a goal in the map, in place of any other.
  /// @param next  goals that follow it, as far as they are known; the last is the goal itself when they form a loop
  virtual void setGoal(const Pose2 & goal, std::vector<Pose2> next) = 0;
  /// Replaces the goals that follow the goal. @return whether plans made so far no longer fit
  virtual bool setNextGoals(std::vector<Pose2> next) = 0;
  /// The goal has ended.
  /// @param reached  whether the car is there; else it is to stop
  virtual void endGoal(double time, bool reached) = 0;
  /// Whether it drives on all the same.
  virtual bool drivesOn() const = 0;
  /// Gives up goal and way.
  virtual void stop() = 0;

  /// What to ask of the global planner. Only with a goal.
  virtual PlanRequest request(const Situation & situation) const = 0;
  enum class Reception
  {
    kRefused,  ///< the car cannot switch to the plan
    kKept,     ///< it can, but what it drives along is better
    kStarted
  };
  /// @param plan  as asked for, found
  virtual Reception setPlan(Plan plan, const Situation & situation) = 0;
  /// There is none.
  /// @return whether that has been made easier, such as by moving a goal that is only passed: then it is asked for again
  virtual bool noteNoPlan(SearchStatus status, const Costmap & costmap) = 0;
  /// What the car drives along, empty before the first plan.
  virtual const Path & way() const = 0;

  virtual LocalStep computeVelocityCommands(const Situation & situation, Manner manner) = 0;
  virtual bool isGoalReached(const CarState & car) const = 0;
};

/// What a library registers, by CLASS_LOADER_REGISTER_CLASS(PACKAGE::CLASS, move_base::LocalPlannerPlugin), to be chosen as
/// base_local_planner: PACKAGE/CLASS. The library is libPACKAGE_planners.so.
class LocalPlannerPlugin
{
public:
  virtual ~LocalPlannerPlugin() = default;
  /// @throws OptionError for a parameter that cannot be used
  virtual std::unique_ptr<LocalPlanner> create(const PlannerSetup & setup) const = 0;
};
}  // namespace move_base
