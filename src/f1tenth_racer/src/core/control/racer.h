#pragma once

#include <move_base/local_planner.h>

#include <optional>
#include <vector>

#include "control/car_watch.h"
#include "control/path_follower.h"
#include "control/plan_requests.h"
#include "control/racer_options.h"
#include "control/way.h"
#include "path/terms.h"
#include "seen/lookout.h"

namespace f1tenth_racer
{
/// Drives a car at the limits of its tyres: along race lines, past goals at speed and past others.
class Racer : public LocalPlanner
{
public:
  /// @throws OptionError
  explicit Racer(const RacerOptions & options);

  void observe(const LaserScan & scan, Costmap & costmap) override { lookout_.observe(scan, costmap); }
  CarState update(const CarSighting & sighting, double now, const Costmap & costmap) override;
  void noteCommand(double time, const DriveCommand & command) override;

  void setGoal(const Pose2 & goal, std::vector<Pose2> next) override;
  bool setNextGoals(std::vector<Pose2> next) override;
  void endGoal(double time, bool reached) override;
  bool drivesOn() const override { return coast_until_.has_value(); }
  void stop() override;

  PlanRequest request(const Situation & situation) const override;
  Reception setPlan(Plan plan, const Situation & situation) override;
  bool noteNoPlan(SearchStatus status, const Costmap & costmap) override { return way_.makeRoom(status, costmap); }
  const Path & way() const override { return way_.plan().path; }

  /// By dead reckoning when nothing has been seen for a while.
  LocalStep computeVelocityCommands(const Situation & situation, Manner manner) override;
  bool isGoalReached(const CarState & car) const override;

private:
  double period(double time) const;

  RacerOptions options_;
  Goals goals_;
  PathFollower follower_;
  PlanRequests requests_;
  Way way_;
  CarWatch car_watch_;
  Lookout lookout_;

  std::optional<double> time_;           // s, of this cycle
  std::optional<double> previous_time_;  // s, of the one before
  std::optional<Pose2> pose_;            // as in this cycle, since the goal was set
  std::optional<Pose2> previous_pose_;
  std::optional<double> coast_until_;  // s
};
}  // namespace f1tenth_racer
