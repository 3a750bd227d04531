#pragma once

#include <vector>

#include "move_base/local_planner.h"
#include "move_base/path/path_tracker.h"

namespace move_base
{
struct PathFollowerOptions
{
  double max_vel_x{0.4};                 ///< m/s
  double max_vel_x_backwards{0.2};       ///< m/s
  double max_vel_theta{0.3};             ///< rad/s
  double min_vel_x{0.15};                ///< m/s, least speed when creeping to the end of a path
  double acc_lim_x{0.5};                 ///< m/s^2, speeding up and slowing down
  double max_lateral_acceleration{2.0};  ///< m/s^2
  double max_steering_angle{0.4189};     ///< rad
  double wheelbase{0.3302};              ///< m
  double stop_clearance{0.0};            ///< m, the car stops before a place with less
  double xy_goal_tolerance{0.2};         ///< m, in which a car stands at its goal
  double yaw_goal_tolerance{0.2};        ///< rad

  /// @throws OptionError
  void validate() const;
};

/// The plain local planner: pure pursuit of the plan, slow enough for its bends, to a stop at the goal. Goals that follow
/// are not looked at.
class PathFollower : public LocalPlanner
{
public:
  /// @throws OptionError
  explicit PathFollower(const PathFollowerOptions & options);

  CarState update(const CarSighting & sighting, double now, const Costmap & costmap) override;
  void noteCommand(double time, const DriveCommand & command) override;

  void setGoal(const Pose2 & goal, std::vector<Pose2> next) override;
  bool setNextGoals(std::vector<Pose2> next) override;
  void endGoal(double time, bool reached) override;
  bool drivesOn() const override { return coasts_; }
  void stop() override;

  PlanRequest request(const Situation & situation) const override;
  Reception setPlan(Plan plan, const Situation & situation) override;
  bool noteNoPlan(SearchStatus, const Costmap &) override { return false; }
  const Path & way() const override { return path_; }

  LocalStep computeVelocityCommands(const Situation & situation, Manner manner) override;
  bool isGoalReached(const CarState & car) const override;

private:
  double pursue(const PathPosition & here, const CarState & car) const;
  double speedAt(const PathPoint & point) const;
  double speedAlong(const PathPosition & here, double way_free) const;
  double wayFree(const PathPosition & here, const Costmap & costmap) const;
  double slewed(double wanted, double measured, bool brake) const;

  PathFollowerOptions options_;
  Pose2 goal_;
  Path path_;
  PathTracker tracker_;
  bool new_way_{false};
  bool coasts_{false};
  double time_{0.0};    // s
  double period_{0.0};  // s, since the cycle before
  DriveCommand last_;
};
}  // namespace move_base
