#include "way.h"

#include <cmath>

#include "traffic/passing.h"

namespace move_base
{
namespace
{
constexpr double kLookInterval = 0.1;  // s between looks for a way past others
constexpr double kKeptPart = 0.7;      // of the goal tolerance, within which ways past others pass goals
}  // namespace

Way::Renewal Way::renew(PlanAnswer answer, const Scene & scene)
{
  const bool past = leadsPastOthers(scene);
  const bool drivable = !follower_.hasPath() || requests_.canDrive(answer.plan, scene.car, scene.costmap);
  if (!past && !drivable) {
    return Renewal::kRefused;
  }
  if (!past) {
    start(std::move(answer), scene);
  } else if (!drivable || !goOver(std::move(answer), scene)) {
    keep(scene);
    return Renewal::kKept;
  }
  return Renewal::kStarted;
}

void Way::makeRoom(SearchStatus status, const Costmap & costmap)
{
  if (status == SearchStatus::kGoalBlocked && requests_.passes()) {
    for (const double clearance : clearancesFrom(options_.planner.min_obstacle_dist)) {
      if (goals_.moveAside(costmap, clearance)) {
        break;
      }
    }
  }
}

void Way::start(PlanAnswer answer, const Scene & scene)
{
  races_ = answer.races;
  next_look_ = scene.time;
  take(std::move(answer.plan), scene.costmap, {});
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
bool Way::goOver(PlanAnswer answer, const Scene & scene)
{
  const PathFollower before = follower_;
  const Pose2 goal = goals_.front();
  Plan old = plan_;
  const bool raced = races_;
  const bool was_changed = changed_;
  start(std::move(answer), scene);
  if (passOthers(scene) && !follower_.hindered(scene.car, scene.costmap, scene.others)) {
    return true;
  }
  goals_.move(goal);
  plan_ = std::move(old);
  races_ = raced;
  changed_ = was_changed;
  follower_ = before;
  return false;
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

bool Way::passOthers(const Scene & scene)
{
  if (!follower_.hindered(scene.car, scene.costmap, scene.others)) {
    return true;
  }
  if (scene.time < next_look_) {
    return false;
  }
  next_look_ = scene.time + kLookInterval;
  const PlanRequest request = requests_.from(scene.car, 0.0);
  if (request.lead.empty() || !request.race_line) {
    return false;
  }
  auto past = planPast(
    {scene.costmap, options_.planner, follower_.options().limits, plan_, request, scene.others,
     follower_.placeOf(scene.car), scene.car});
  if (past) {
    take(std::move(past->plan), scene.costmap, past->caution);
    moveGoalHere();
  }
  return past.has_value();
}

bool Way::isOver(const FollowStep & step, const CarState & car, double time_needed) const
{
  const double left = plan_.goal_s - step.position.s;
  const bool approaches = races_ && !requests_.passes() && !requests_.isFar(left, car.speed, time_needed);
  const bool passed = left < -requests_.tolerance().distance;
  const bool missed = step.at_end && car.stands();
  return step.lost || step.blocked || missed || passed || approaches;
}
}  // namespace move_base
