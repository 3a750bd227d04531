#include "move_base/control/navigator.h"

#include <utility>

namespace move_base
{
namespace
{
constexpr double kStopTime = 1.0;   // s, for which a car that has been stopped is commanded to stop
constexpr double kStartTime = 1.0;  // s, within which a car moves that is told to
}  // namespace

Navigator::Navigator(
  const NavigatorOptions & options, std::unique_ptr<GlobalPlanner> global, std::unique_ptr<LocalPlanner> local,
  PlanWorker worker)
: options_(options),
  global_(std::move(global)),
  local_(std::move(local)),
  planning_(options_, *global_, *local_, std::move(worker)),
  recovery_(options.recoveries, options.oscillation_timeout, options.oscillation_distance, options.backing_speed)
{
  options_.validate();
}

void Navigator::setGoal(const Pose2 & goal, double time, std::vector<Pose2> next)
{
  active_ = true;
  local_->setGoal(goal, std::move(next));
  planning_.drop();
  planning_.forgetReason();
  planAgain(time);
  recovery_.startAgain(time);
  last_valid_control_ = time;
  stop_until_ = 0.0;
}

void Navigator::setNextGoals(std::vector<Pose2> next)
{
  if (!local_->setNextGoals(std::move(next))) {
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
  active_ = false;
  planning_.drop();
  stop();
}

// A single message may be lost, or come before one that was under way.
void Navigator::stop()
{
  local_->stop();
  stop_until_ = previous_time_.value_or(0.0) + kStopTime;
}

CycleOutput Navigator::cycle(const CycleInput & input, Costmap & costmap)
{
  if (previous_time_ && input.time < *previous_time_) {
    stop_until_ = *previous_time_ < stop_until_ ? input.time + kStopTime : 0.0;
  }
  const double seen = input.time - input.age;
  const double measured = input.sensors_current ? seen : input.time - input.speed_age;
  const Situation now{
    input.time, local_->update({input.car, seen, measured}, input.time, costmap), costmap, planning_.timeNeeded()};
  CycleOutput output;
  drive(input.sensors_current, now, costmap, output);
  if (active_ && !planning_.noPlanBecause().empty()) {
    output.trouble = planning_.noPlanBecause();
  }
  previous_time_ = now.time;
  local_->noteCommand(now.time, output.command.value_or(DriveCommand{}));
  return output;
}

void Navigator::drive(bool sensors_current, const Situation & now, Costmap & costmap, CycleOutput & output)
{
  if (!sensors_current) {
    if (drives()) {
      driveBlind(now, output);
    }
  } else if (active_) {
    pursue(now, costmap, output);
  } else if (local_->drivesOn()) {
    coast(now, output);
  }
  if (!output.command && now.time < stop_until_) {
    output.command = DriveCommand{};
  }
}

// A fast car that stops with its wheels straight leaves the road: it brakes along its way.
void Navigator::driveBlind(const Situation & now, CycleOutput & output)
{
  if (now.car.stands()) {
    output.command = DriveCommand{};
    planning_.drop();
    planning_.startAgain(now.time);
    recovery_.countFrom(now.time);
    last_valid_control_ = now.time;
    state_ = state_ == State::kControlling ? State::kPlanning : state_;
  } else {
    follow(now, Manner::kBrake, output);
  }
}

void Navigator::pursue(const Situation & now, Costmap & costmap, CycleOutput & output)
{
  recovery_.note(now.car.pose, now.time);
  switch (state_) {
    case State::kPlanning:
      planAhead(now, costmap, output);
      break;
    case State::kControlling:
      control(now, costmap, output);
      break;
    case State::kBackingUp:
      driveBack(now, output);
      break;
  }
}

// Without a plan for the new goal the car comes to a stop along the old one, not wherever its wheels point.
void Navigator::planAhead(const Situation & now, Costmap & costmap, CycleOutput & output)
{
  if (std::optional<PlanAnswer> answer = planning_.answer(now)) {
    takePlan(std::move(*answer), now, costmap, output);
  } else {
    follow(now, planning_.leavesWayAt(now.time) ? Manner::kKeepWay : Manner::kBrake, output);
  }
  if (active_ && state_ == State::kPlanning) {
    finishIfReached(now, output);
  }
}

void Navigator::takePlan(PlanAnswer answer, const Situation & now, Costmap & costmap, CycleOutput & output)
{
  const bool found = answer.plan.found();
  if (!found && !local_->noteNoPlan(answer.plan.status, costmap)) {
    planFailed(answer.obstruction, now, costmap, output);
    return;
  }
  const auto reception = found ? local_->setPlan(std::move(answer.plan), now) : LocalPlanner::Reception::kRefused;
  if (reception == LocalPlanner::Reception::kRefused) {
    planning_.refused(now.time);
    follow(now, Manner::kBrake, output);
    return;
  }
  planning_.succeeded(now.time, reception == LocalPlanner::Reception::kStarted);
  state_ = State::kControlling;
  control(now, costmap, output);
}

void Navigator::planFailed(
  const Obstruction & obstruction, const Situation & now, Costmap & costmap, CycleOutput & output)
{
  planning_.failed(obstruction.reason);
  if (obstruction.lasting) {
    giveUp("Failed to find a valid plan. " + obstruction.reason, now, output);
  } else if (planning_.isSpent(now.time) && now.car.stands()) {
    recover(Trigger::kPlanning, now, costmap, output);
  } else {
    follow(now, Manner::kBrake, output);
  }
}

// A car that drives comes to a stop along the way that it has.
void Navigator::giveUp(const std::string & text, const Situation & now, CycleOutput & output)
{
  end({false, text}, now.time, output);
  if (local_->drivesOn() && !now.car.stands()) {
    coast(now, output);
  } else {
    output.command = DriveCommand{};
    stop();
  }
}

void Navigator::control(const Situation & now, Costmap & costmap, CycleOutput & output)
{
  const LocalStep step = follow(now, whyRecover(now.time) ? Manner::kBrake : Manner::kFree, output);
  if (finishIfReached(now, output)) {
    return;
  }
  if (step.stuck) {
    output.trouble = "Something stands in the car's way.";
  }
  // Something that the lidar does not see may hold it; where oscillation is watched for, that finds it.
  const bool is_held = options_.oscillation_timeout == 0.0 && now.car.stands() && step.command.speed != 0.0;
  if (is_held && now.time > last_valid_control_ + kStartTime) {
    output.trouble = "The car does not move though it is told to.";
  }
  if (!step.lost && !step.stuck && !is_held) {
    last_valid_control_ = now.time;
  }
  if (const std::optional<Trigger> trigger = whyRecover(now.time)) {
    if (now.car.stands()) {
      recover(*trigger, now, costmap, output);
    }
  } else if (planning_.isDue(now.time) || (planning_.mayAsk(now.time) && step.wants_plan)) {
    planAgain(now.time);
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

bool Navigator::finishIfReached(const Situation & now, CycleOutput & output)
{
  if (!local_->isGoalReached(now.car)) {
    return false;
  }
  end({true, "Goal reached."}, now.time, output);
  if (!local_->drivesOn()) {
    output.command = DriveCommand{};
    stop();
  }
  return true;
}

void Navigator::end(const Outcome & outcome, double time, CycleOutput & output)
{
  active_ = false;
  output.outcome = outcome;
  local_->endGoal(time, outcome.succeeded);
}

void Navigator::coast(const Situation & now, CycleOutput & output)
{
  const LocalStep step = follow(now, Manner::kKeepWay, output);
  if (now.car.stands() && step.command.speed == 0.0) {
    cancel();
  }
}

LocalStep Navigator::follow(const Situation & now, Manner manner, CycleOutput & output)
{
  LocalStep step = local_->computeVelocityCommands(now, manner);
  output.command = step.command;
  output.new_plan = output.new_plan || step.new_way;
  output.prediction = step.prediction;
  return step;
}

void Navigator::recover(Trigger trigger, const Situation & now, Costmap & costmap, CycleOutput & output)
{
  output.command = DriveCommand{};
  stop();
  if (!options_.recovery_behavior_enabled || recovery_.isSpent()) {
    end({false, failureOf(trigger, planning_.noPlanBecause())}, now.time, output);
    return;
  }
  output.recovery = recovery_.begin(now.car.pose, now.time, costmap);
  state_ = State::kBackingUp;
  if (!recovery_.backsUp()) {
    planAgain(now.time);
  }
}

void Navigator::driveBack(const Situation & now, CycleOutput & output)
{
  output.command = DriveCommand{recovery_.backUp(now.car.pose, now.time, now.costmap), 0.0};
  if (!recovery_.backsUp()) {
    planAgain(now.time);
  }
}

void Navigator::planAgain(double time)
{
  state_ = State::kPlanning;
  planning_.startAgain(time);
}
}  // namespace move_base
