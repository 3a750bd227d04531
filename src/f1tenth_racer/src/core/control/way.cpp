#include "control/way.h"

#include <move_base/planning/way_planner.h>

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kLookInterval = 0.1;  // s between looks for a way past others
constexpr double kKeptPart = 0.7;      // of the goal tolerance, within which ways past others pass goals
}  // namespace

LocalPlanner::Reception Way::renew(Plan plan, const Scene & scene)
{
  const bool past = leadsPastOthers(scene);
  const bool drivable = !follower_.hasPath() || requests_.canDrive(plan, scene.car, scene.costmap);
  if (!past && !drivable) {
    return LocalPlanner::Reception::kRefused;
  }
  if (!past) {
    start(std::move(plan), scene);
  } else if (!drivable || !goOver(std::move(plan), scene)) {
    keep(scene);
    return LocalPlanner::Reception::kKept;
  }
  return LocalPlanner::Reception::kStarted;
}

bool Way::makeRoom(SearchStatus status, const Costmap & costmap)
{
  const std::vector<double> clearances = clearancesFrom(options_.planner.min_obstacle_dist);
  return status == SearchStatus::kGoalBlocked && requests_.passes() &&
         std::any_of(
           clearances.begin(), clearances.end(), [&](double each) { return goals_.moveAside(costmap, each); });
}

void Way::start(Plan plan, const Scene & scene)
{
  races_ = plan.races;
  next_look_ = scene.time;
  take(std::move(plan), scene.costmap, {});
}

void Way::take(Plan plan, const Costmap & costmap, const Caution & caution)
{
  plan_ = std::move(plan);
  changed_ = true;
  follower_.setPath(plan_.path, costmap, caution);
}

// Whether others drive about, and none of them is in the way.
bool Way::leadsPastOthers(const Scene & scene) const
{
  return !scene.others.empty() && follower_.hasPath() && follower_.canDriveOn(scene.car) &&
         !follower_.hindered(scene.car, scene.costmap, scene.others);
}

// Starts on the plan if no other car is in the way there, or on a way past them that leads into it.
bool Way::goOver(Plan plan, const Scene & scene)
{
  PathFollower trial = follower_;
  trial.setPath(plan.path, scene.costmap);
  next_look_ = scene.time;
  std::optional<PassingPlan> past;
  if (trial.hindered(scene.car, scene.costmap, scene.others)) {
    past = lookPast(plan, trial, scene);
    if (!past) {
      return false;
    }
    trial.setPath(past->plan.path, scene.costmap, past->caution);
    if (trial.hindered(scene.car, scene.costmap, scene.others)) {
      return false;
    }
  }
  races_ = plan.races;
  if (past) {
    swingOut(std::move(*past), scene.costmap);
  } else {
    take(std::move(plan), scene.costmap, {});
  }
  return true;
}

void Way::keep(const Scene & scene)
{
  const double here = follower_.placeOf(scene.car);
  plan_.goal_s = placeOnPath(plan_.path, goals_.front(), here + distance(scene.car.pose, goals_.front()));
  if (!moveGoalHere()) {
    // It does not lead to the goal: another plan is asked for as soon as may be.
    plan_.goal_s = here - 2.0 * requests_.tolerance().distance;
  }
}

// A goal that is only to be passed is passed wherever the way past others leads beside it.
bool Way::moveGoalHere()
{
  constexpr double kAlong = 0.2;  // m
  constexpr double kAside = 1.0;  // m
  const Pose2 & there = plan_.path[firstBeyond(plan_.path, plan_.goal_s)].pose;
  const Pose2 beside = compose(inverse(goals_.front()), there);
  if (!requests_.passes() || std::abs(beside.x) > kAlong || std::abs(beside.y) > kAside) {
    return false;
  }
  if (std::abs(beside.y) > kKeptPart * requests_.tolerance().distance) {
    goals_.move(there);
  }
  return true;
}

void Way::passOthers(const Scene & scene)
{
  if (!follower_.hindered(scene.car, scene.costmap, scene.others) || scene.time < next_look_) {
    return;
  }
  if (auto past = lookPast(plan_, follower_, scene)) {
    swingOut(std::move(*past), scene.costmap);
  }
}

// A way past others that leads into a plan, on whose path the follower is.
std::optional<PassingPlan> Way::lookPast(const Plan & plan, const PathFollower & follower, const Scene & scene)
{
  next_look_ = scene.time + kLookInterval;
  const PlanRequest request = requests_.from(scene.car, 0.0, follower);
  if (request.lead.empty() || !request.race_line) {
    return std::nullopt;
  }
  return planPast(
    {scene.costmap, options_.planner, follower.options().limits, plan, request, scene.others,
     follower.placeOf(scene.car), scene.car, follower.options().traffic});
}

void Way::swingOut(PassingPlan past, const Costmap & costmap)
{
  take(std::move(past.plan), costmap, past.caution);
  moveGoalHere();
}

bool Way::isOver(const FollowStep & step, const CarState & car, double time_needed) const
{
  const double left = plan_.goal_s - step.position.s;
  const bool approaches = races_ && !requests_.passes() && !requests_.isFar(left, car.speed, time_needed);
  const bool passed = left < -requests_.tolerance().distance;
  const bool missed = step.at_end && car.stands();
  return step.lost || step.blocked || missed || passed || approaches;
}
}  // namespace f1tenth_racer
