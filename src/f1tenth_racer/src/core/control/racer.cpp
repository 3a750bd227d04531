#include "control/racer.h"

#include <algorithm>
#include <utility>

#include "traffic/traffic.h"

namespace f1tenth_racer
{
namespace
{
constexpr double kLongestPeriod = 0.2;  // s, assumed for a step after a pause
}  // namespace

Racer::Racer(const RacerOptions & options)
: options_(options),
  follower_(options.follower),
  requests_(options_, goals_, follower_),
  way_(options_, goals_, requests_, follower_),
  car_watch_(options.follower)
{
  options_.validate();
}

CarState Racer::update(const CarSighting & sighting, double now, const Costmap & costmap)
{
  if (time_ && now < *time_) {
    car_watch_.clear();
  }
  previous_time_ = std::exchange(time_, now);
  const CarState car = car_watch_.note(sighting, now);
  follower_.setHandling(car_watch_.lags(), car_watch_.tyres(), costmap);
  previous_pose_ = std::exchange(pose_, car.pose);
  return car;
}

void Racer::noteCommand(double time, const DriveCommand & command)
{
  car_watch_.noteCommand(time, command, follower_.lastBend());
}

void Racer::setGoal(const Pose2 & goal, std::vector<Pose2> next)
{
  goals_.set(goal, std::move(next));
  pose_.reset();
  coast_until_.reset();
}

bool Racer::setNextGoals(std::vector<Pose2> next)
{
  const bool passed = requests_.passes();
  goals_.setNext(std::move(next));
  return requests_.passes() != passed;
}

// A goal that is passed leads into the next one; a goal that was given up is left along the way that the car is on.
void Racer::endGoal(double time, bool reached)
{
  if (follower_.hasPath() && (!reached || requests_.passes())) {
    coast_until_ = time + (reached ? options_.coast_time : 0.0);
  }
  goals_.clear();
}

void Racer::stop()
{
  goals_.clear();
  coast_until_.reset();
  follower_.clear();
}

PlanRequest Racer::request(const Situation & situation) const
{
  return requests_.from(situation.car, situation.plan_time);
}

Racer::Reception Racer::setPlan(Plan plan, const Situation & situation)
{
  return way_.renew(
    std::move(plan), {situation.time, situation.car, situation.costmap,
                      forecasts(lookout_.moving(), situation.costmap, situation.time, situation.car.pose)});
}

LocalStep Racer::computeVelocityCommands(const Situation & situation, Manner manner)
{
  LocalStep result;
  if (!follower_.hasPath()) {
    return result;
  }
  const Scene scene{
    situation.time, situation.car, situation.costmap,
    forecasts(lookout_.moving(), situation.costmap, situation.time, situation.car.pose)};
  if (manner == Manner::kFree) {
    way_.passOthers(scene);
  }
  const bool brake = manner == Manner::kBrake || (coast_until_ && situation.time >= *coast_until_);
  FollowStep step = follower_.step(scene.car, scene.costmap, period(scene.time), brake, scene.others);
  result.command = step.command;
  result.lost = step.lost;
  result.stuck = step.stuck;
  result.wants_plan = goals_.any() && way_.isOver(step, scene.car, situation.plan_time);
  result.new_way = way_.takeChange();
  result.prediction = std::move(step.prediction);
  return result;
}

bool Racer::isGoalReached(const CarState & car) const
{
  const Pose2 since = requests_.passes() ? previous_pose_.value_or(car.pose) : car.pose;
  return cameNear(since, car.pose, goals_.front(), requests_.tolerance()) && (requests_.passes() || car.stands());
}

double Racer::period(double time) const
{
  return previous_time_ ? std::clamp(time - *previous_time_, 0.0, kLongestPeriod) : 0.0;
}
}  // namespace f1tenth_racer
