#include "move_base/control/path_follower.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace move_base
{
namespace
{
constexpr double kEndReached = 0.03;       // m
constexpr double kStopMargin = 0.1;        // m, left before an obstacle
constexpr double kStuck = 0.12;            // m, of free way, with which a car does not drive on
constexpr double kBrakingPart = 0.6;       // of acc_lim_x, that is planned with: a car brakes late
constexpr double kLookAhead = 0.45;        // m ahead on its path, that the car steers for
constexpr double kLookAheadTime = 0.12;    // s, added to it per m/s
constexpr double kReplanDistance = 2.5;    // m beyond the braking distance, up to which an obstacle leads to a new plan
constexpr double kMaxDeviation = 0.5;      // m, a car farther from its path has lost it
constexpr double kMaxHeadingError = 1.2;   // rad, beyond it steering back does not work
constexpr double kCreep = 1e-3;            // m/s; without speed a Twist does not set the wheels
constexpr double kSpeedSlack = 0.5;        // m/s, by which the speed commanded may differ from the one measured
constexpr double kLongestPeriod = 0.2;     // s, assumed for a step after a pause
constexpr double kPredictionLength = 3.0;  // m
}  // namespace

void PathFollowerOptions::validate() const
{
  requirePositive("max_vel_x", max_vel_x);
  requirePositive("max_vel_x_backwards", max_vel_x_backwards);
  requirePositive("max_vel_theta", max_vel_theta);
  requireOption(min_vel_x > 0.0 && min_vel_x <= max_vel_x, "min_vel_x", min_vel_x, "above 0 and at most max_vel_x");
  requirePositive("acc_lim_x", acc_lim_x);
  requirePositive("max_lateral_acceleration", max_lateral_acceleration);
  requireOption(
    max_steering_angle > 0.0 && max_steering_angle < 0.5 * M_PI, "max_steering_angle", max_steering_angle,
    "above 0 and below pi/2");
  requirePositive("wheelbase", wheelbase);
  requireNotNegative("stop_clearance", stop_clearance);
  requirePositive("xy_goal_tolerance", xy_goal_tolerance);
  requirePositive("yaw_goal_tolerance", yaw_goal_tolerance);
}

PathFollower::PathFollower(const PathFollowerOptions & options) : options_(options)
{
  options_.validate();
}

CarState PathFollower::update(const CarSighting & sighting, double now, const Costmap &)
{
  period_ = std::clamp(now - time_, 0.0, kLongestPeriod);
  time_ = now;
  return sighting.car;
}

void PathFollower::noteCommand(double, const DriveCommand & command)
{
  last_ = command;
}

void PathFollower::setGoal(const Pose2 & goal, std::vector<Pose2>)
{
  goal_ = goal;
  coasts_ = false;
}

bool PathFollower::setNextGoals(std::vector<Pose2>)
{
  return false;
}

void PathFollower::endGoal(double, bool reached)
{
  coasts_ = !reached && !path_.empty();
}

void PathFollower::stop()
{
  path_.clear();
  coasts_ = false;
}

PlanRequest PathFollower::request(const Situation & situation) const
{
  return {situation.car.pose, goal_, situation.car.stands() ? 0.0 : last_.curvature};
}

// A car that would have to turn round stops first.
PathFollower::Reception PathFollower::setPlan(Plan plan, const Situation & situation)
{
  if (!situation.car.stands() && plan.path.front().reverse != (situation.car.speed < 0.0)) {
    return Reception::kRefused;
  }
  path_ = std::move(plan.path);
  tracker_ = PathTracker(path_);
  new_way_ = true;
  return Reception::kStarted;
}

LocalStep PathFollower::computeVelocityCommands(const Situation & situation, Manner manner)
{
  LocalStep step;
  if (path_.empty()) {
    return step;
  }
  const CarState & car = situation.car;
  if (tracker_.locate(path_, car.pose).remaining <= kEndReached && car.stands()) {
    tracker_.nextStretch();
  }
  const PathPosition here = tracker_.moveTo(path_, car.pose);
  const double way_free = wayFree(here, situation.costmap);
  const double braking = 0.5 * car.speed * car.speed / options_.acc_lim_x;
  const bool at_end = here.remaining <= kEndReached;
  step.lost = std::abs(here.lateral) > kMaxDeviation || std::abs(here.heading_error) > kMaxHeadingError;
  step.stuck = way_free <= kStuck;
  step.wants_plan =
    step.lost || way_free <= braking + kReplanDistance || (at_end && tracker_.onLastStretch() && car.stands());
  step.new_way = std::exchange(new_way_, false);
  const bool brake = manner == Manner::kBrake || coasts_;
  const double speed = brake || step.lost || at_end ? 0.0 : speedAlong(here, way_free);
  step.command = {slewed(here.reverse ? -speed : speed, car.speed, brake), pursue(here, car)};
  if (!car.stands() && std::abs(step.command.speed) < kCreep && !brake) {
    step.command.speed = std::copysign(kCreep, car.speed);
  }
  const std::size_t end = firstBeyond(path_, here.s + kPredictionLength, here.index);
  std::transform(
    path_.begin() + static_cast<std::ptrdiff_t>(here.index), path_.begin() + static_cast<std::ptrdiff_t>(end) + 1,
    std::back_inserter(step.prediction), [](const PathPoint & point) { return point.pose; });
  return step;
}

bool PathFollower::isGoalReached(const CarState & car) const
{
  return car.stands() && distance(car.pose, goal_) <= options_.xy_goal_tolerance &&
         std::abs(normalizeAngle(car.pose.yaw - goal_.yaw)) <= options_.yaw_goal_tolerance;
}

// The curvature, 1/m, of the arc to a point ahead on the path; beyond the end of a stretch it goes straight on.
double PathFollower::pursue(const PathPosition & here, const CarState & car) const
{
  const double ahead = kLookAhead + kLookAheadTime * std::abs(car.speed);
  const double way = here.reverse ? -1.0 : 1.0;
  std::size_t i = here.index;
  while (i + 1 < path_.size() && path_[i + 1].reverse == here.reverse && path_[i].s < here.s + ahead) {
    ++i;
  }
  const Pose2 target = advance(path_[i].pose, way * std::max(0.0, here.s + ahead - path_[i].s), 0.0);
  const Pose2 seen = compose(inverse(car.pose), target);
  const double bend = 2.0 * seen.y / std::max(seen.x * seen.x + seen.y * seen.y, ahead * ahead);
  const double most = maths::tan(options_.max_steering_angle) / options_.wheelbase;
  return std::clamp(bend, -most, most);
}

double PathFollower::speedAt(const PathPoint & point) const
{
  const double cruise = point.reverse ? options_.max_vel_x_backwards : options_.max_vel_x;
  const double bend = std::abs(point.curvature);
  if (bend == 0.0) {
    return cruise;
  }
  return std::min({cruise, std::sqrt(options_.max_lateral_acceleration / bend), options_.max_vel_theta / bend});
}

// As fast as the car can slow down in time for what lies ahead.
double PathFollower::speedAlong(const PathPosition & here, double way_free) const
{
  const double braking = kBrakingPart * options_.acc_lim_x;
  const double stop = std::max(0.0, std::min(here.remaining, way_free - kStopMargin));
  double squared = options_.max_vel_x * options_.max_vel_x;
  for (std::size_t i = here.index; i < path_.size() && path_[i].s <= here.s + stop; ++i) {
    const double way = std::max(0.0, path_[i].s - here.s);
    const double speed = speedAt(path_[i]);
    squared = std::min(squared, speed * speed + 2.0 * braking * way);
  }
  const double most = std::min(std::sqrt(squared), std::sqrt(2.0 * braking * stop));
  return stop > 0.0 ? std::max(most, options_.min_vel_x) : 0.0;
}

// How far the path is free, m. A car that stands closer to something may drive away from it.
double PathFollower::wayFree(const PathPosition & here, const Costmap & costmap) const
{
  const double braking = 0.5 * options_.max_vel_x * options_.max_vel_x / options_.acc_lim_x;
  const double allowed = std::min(options_.stop_clearance, costmap.clearance(path_[here.index].pose) - 0.01);
  for (std::size_t i = here.index; i < path_.size() && path_[i].s <= here.s + braking + kReplanDistance; ++i) {
    if (costmap.clearance(path_[i].pose) < allowed) {
      return std::max(0.0, path_[i].s - here.s);
    }
  }
  return HUGE_VAL;
}

// What is measured may be old when the car is to brake.
double PathFollower::slewed(double wanted, double measured, bool brake) const
{
  const double from = brake ? last_.speed : std::clamp(last_.speed, measured - kSpeedSlack, measured + kSpeedSlack);
  const double step = options_.acc_lim_x * period_;
  return from + std::clamp(wanted - from, -step, step);
}
}  // namespace move_base
