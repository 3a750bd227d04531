#include "navigator.h"

#include <algorithm>

#include "traffic/traffic.h"

namespace move_base
{
namespace
{
constexpr double kStopTime = 1.0;       // s, for which a car that has been stopped is commanded to stop
constexpr double kStartTime = 1.0;      // s, within which a car moves that is told to
constexpr double kLongestPeriod = 0.2;  // s, assumed for a step after a pause
}  // namespace

Navigator::Navigator(const NavigatorOptions & options, PlanWorker worker)
: options_(options),
  follower_(options.follower),
  requests_(options_, goals_, follower_),
  planning_(options_, requests_, std::move(worker)),
  way_(options_, goals_, requests_, follower_),
  car_watch_(options.follower),
  recovery_(
    options.recoveries, options.oscillation_timeout, options.oscillation_distance,
    options.follower.limits.max_vel_x_backwards)
{
  options_.validate();
}

void Navigator::setGoal(const Pose2 & goal, double time, std::vector<Pose2> next)
{
  goals_.set(goal, std::move(next));
  planning_.drop();
  planning_.forgetReason();
  planAgain(time);
  recovery_.startAgain(time);
  last_valid_control_ = time;
  previous_pose_.reset();
  coast_until_.reset();
  stop_until_ = 0.0;
}

void Navigator::setNextGoals(std::vector<Pose2> next)
{
  const bool passed = requests_.passes();
  goals_.setNext(std::move(next));
  if (requests_.passes() == passed) {
    return;
  }
  planning_.drop();
  const double now = previous_time_.value_or(0.0);
  if (state_ == State::kControlling) {
    planAgain(now);
  } else if (state_ == State::kPlanning) {
    planning_.askFrom(now);
  }
}

void Navigator::cancel()
{
  goals_.clear();
  planning_.drop();
  coast_until_.reset();
  stop();
}

// A single message may be lost, or come before one that was under way.
void Navigator::stop()
{
  follower_.clear();
  stop_until_ = previous_time_.value_or(0.0) + kStopTime;
}

CycleOutput Navigator::cycle(const CycleInput & input, Costmap & costmap)
{
  if (previous_time_ && input.time < *previous_time_) {
    car_watch_.clear();
    stop_until_ = *previous_time_ < stop_until_ ? input.time + kStopTime : 0.0;
  }
  CycleInput now = input;
  const double seen = input.time - input.age;
  const double measured = input.sensors_current ? seen : input.time - input.speed_age;
  now.car = car_watch_.note({input.car, seen, measured}, input.time);
  follower_.setHandling(car_watch_.lags(), car_watch_.tyres(), costmap);
  CycleOutput output;
  drive(now, costmap, output);
  output.new_plan = way_.takeChange();
  if (active() && !planning_.noPlanBecause().empty()) {
    output.trouble = planning_.noPlanBecause();
  }
  previous_time_ = now.time;
  previous_pose_ = now.car.pose;
  car_watch_.noteCommand(now.time, output.command.value_or(DriveCommand{}), follower_.lastBend());
  return output;
}

void Navigator::drive(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  if (!input.sensors_current) {
    if (drives()) {
      driveBlind(input, costmap, output);
    }
  } else if (goals_.any()) {
    pursue(input, costmap, output);
  } else if (coast_until_) {
    coast(input, costmap, output);
  }
  if (!output.command && input.time < stop_until_) {
    output.command = DriveCommand{};
  }
}

// A fast car that stops with its wheels straight leaves the road: it brakes along its path, by dead reckoning.
void Navigator::driveBlind(const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  if (input.car.stands()) {
    output.command = DriveCommand{};
    planning_.drop();
    planning_.startAgain(input.time);
    recovery_.countFrom(input.time);
    last_valid_control_ = input.time;
    state_ = state_ == State::kControlling ? State::kPlanning : state_;
  } else {
    hold(input, costmap, output);
  }
}

void Navigator::pursue(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  recovery_.note(input.car.pose, input.time);
  switch (state_) {
    case State::kPlanning:
      planAhead(input, costmap, output);
      break;
    case State::kControlling:
      control(input, costmap, output);
      break;
    case State::kBackingUp:
      driveBack(input, costmap, output);
      break;
  }
}

void Navigator::planAhead(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  if (std::optional<PlanAnswer> answer = planning_.answer(input.car, input.time, costmap)) {
    takePlan(std::move(*answer), input, costmap, output);
  } else if (planning_.leavesWayAt(input.time) && follower_.hasPath()) {
    follow({input.time, input.car, costmap, forecasts(costmap, input.time, input.car.pose)}, false, output);
  } else {
    hold(input, costmap, output);
  }
  if (goals_.any() && state_ == State::kPlanning && requests_.passes()) {
    finishIfReached(input, output);
  }
}

void Navigator::takePlan(PlanAnswer answer, const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  if (!answer.plan.found()) {
    way_.makeRoom(answer.plan.status, costmap);
    planFailed(answer.obstruction, input, costmap, output);
    return;
  }
  const auto renewal =
    way_.renew(std::move(answer), {input.time, input.car, costmap, forecasts(costmap, input.time, input.car.pose)});
  if (renewal == Way::Renewal::kRefused) {
    planning_.refused(input.time);
    hold(input, costmap, output);
    return;
  }
  planning_.succeeded(input.time, renewal == Way::Renewal::kStarted);
  state_ = State::kControlling;
  control(input, costmap, output);
}

void Navigator::planFailed(
  const Obstruction & obstruction, const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  planning_.failed(obstruction.reason);
  if (obstruction.lasting) {
    giveUp("Failed to find a valid plan. " + obstruction.reason, input, costmap, output);
  } else if (planning_.isSpent(input.time) && input.car.stands()) {
    recover(Trigger::kPlanning, input, costmap, output);
  } else {
    hold(input, costmap, output);
  }
}

// A car that drives comes to a stop along the path that it has.
void Navigator::giveUp(
  const std::string & text, const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  goals_.clear();
  output.outcome = Outcome{false, text};
  if (!input.car.stands() && follower_.hasPath()) {
    coast_until_ = input.time;
    coast(input, costmap, output);
  } else {
    output.command = DriveCommand{};
    stop();
  }
}

void Navigator::control(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  const std::vector<Forecast> others = forecasts(costmap, input.time, input.car.pose);
  const Scene scene{input.time, input.car, costmap, others};
  way_.passOthers(scene);
  const FollowStep step = follow(scene, whyRecover(input.time).has_value(), output);
  if (finishIfReached(input, output)) {
    return;
  }
  if (step.stuck) {
    output.trouble = "Something stands in the car's way.";
  }
  // Something that the lidar does not see may hold it; where oscillation is watched for, that finds it.
  const bool is_held = options_.oscillation_timeout == 0.0 && input.car.stands() && step.command.speed != 0.0;
  if (is_held && input.time > last_valid_control_ + kStartTime) {
    output.trouble = "The car does not move though it is told to.";
  }
  if (!step.lost && !step.stuck && !is_held) {
    last_valid_control_ = input.time;
  }
  if (const std::optional<Trigger> trigger = whyRecover(input.time)) {
    if (input.car.stands()) {
      recover(*trigger, input, costmap, output);
    }
  } else if (
    planning_.isDue(input.time) ||
    (planning_.mayAsk(input.time) && way_.isOver(step, input.car, planning_.timeNeeded()))) {
    planAgain(input.time);
  }
}

std::optional<Trigger> Navigator::whyRecover(double time) const
{
  if (recovery_.oscillates(time)) {
    return Trigger::kOscillation;
  }
  if (time > last_valid_control_ + options_.controller_patience) {
    return Trigger::kControlling;
  }
  return std::nullopt;
}

bool Navigator::finishIfReached(const CycleInput & input, CycleOutput & output)
{
  const Pose2 & here = input.car.pose;
  const Pose2 & since = requests_.passes() ? previous_pose_.value_or(here) : here;
  if (!cameNear(since, here, goals_.front(), requests_.tolerance()) || !(requests_.passes() || input.car.stands())) {
    return false;
  }
  output.outcome = Outcome{true, "Goal reached."};
  if (requests_.passes() && follower_.hasPath()) {
    coast_until_ = input.time + options_.coast_time;
  } else {
    output.command = DriveCommand{};
    stop();
  }
  goals_.clear();
  return true;
}

void Navigator::coast(const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  const Scene scene{input.time, input.car, costmap, forecasts(costmap, input.time, input.car.pose)};
  const FollowStep step = follow(scene, input.time >= *coast_until_, output);
  if (input.car.stands() && step.command.speed == 0.0) {
    cancel();
  }
}

FollowStep Navigator::follow(const Scene & scene, bool brake, CycleOutput & output)
{
  FollowStep step = follower_.step(scene.car, scene.costmap, period(scene.time), brake, scene.others);
  output.command = step.command;
  output.prediction = std::move(step.prediction);
  return step;
}

// Without a plan for the new goal the car comes to a stop along the old one, not wherever its wheels point.
void Navigator::hold(const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  output.command =
    follower_.hasPath() ? follower_.step(input.car, costmap, period(input.time), true).command : DriveCommand{};
}

void Navigator::recover(Trigger trigger, const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  output.command = DriveCommand{};
  stop();
  if (!options_.recovery_behavior_enabled || recovery_.isSpent()) {
    goals_.clear();
    output.outcome = Outcome{false, failureOf(trigger, planning_.noPlanBecause())};
    return;
  }
  output.recovery = recovery_.begin(input.car.pose, input.time, costmap);
  state_ = State::kBackingUp;
  if (!recovery_.backsUp()) {
    planAgain(input.time);
  }
}

void Navigator::driveBack(const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  output.command = recovery_.backUp(input.car.pose, input.time, costmap);
  if (!recovery_.backsUp()) {
    planAgain(input.time);
  }
}

void Navigator::planAgain(double time)
{
  state_ = State::kPlanning;
  planning_.startAgain(time);
}

double Navigator::period(double time) const
{
  return previous_time_ ? std::clamp(time - *previous_time_, 0.0, kLongestPeriod) : 0.0;
}
}  // namespace move_base
