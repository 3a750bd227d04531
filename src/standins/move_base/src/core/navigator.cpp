#include "navigator.h"

#include <algorithm>

#include "geometry/option_checks.h"
#include "traffic/passing.h"

namespace move_base
{
namespace
{
constexpr double kRetryInterval = 0.5;    // s between plans for the same goal: the world changes no faster
constexpr double kPassingInterval = 0.1;  // s between looks for a way past others
constexpr double kStandingSpeed = 0.05;   // m/s
constexpr double kStopTime = 1.0;         // s, for which a car that has been stopped is told so
constexpr double kLongestPeriod = 0.2;    // s, taken for a step after a pause
constexpr double kProgress = 1.0;         // m from where recovery began
constexpr double kGatePart = 0.75;        // of the goal tolerance, within which plans pass goals
constexpr double kLeadTime = 0.1;         // s beyond the latency, for which a new plan keeps to the old one
constexpr double kApproachLength = 3.0;   // m, on top of the way of braking, that are planned to the goal itself
constexpr double kApproachMargin = 1.0;   // m
constexpr double kTooFast = 0.5;          // m/s, by which a car may be faster than a new plan allows
constexpr double kFarTooFast = 1.5;       // m/s, the same for a plan that is not to end at a standstill
constexpr double kExtensionMargin = 1.0;  // m, of a plan beyond the goal, on top of the way of braking
}  // namespace

void NavigatorOptions::validate() const
{
  requireNotNegative("planner_frequency", planner_frequency);
  requireNotNegative("planner_patience", planner_patience);
  requireNotNegative("controller_patience", controller_patience);
  requireOption(max_planning_retries >= -1, "max_planning_retries", max_planning_retries, "at least -1");
  requireNotNegative("oscillation_timeout", oscillation_timeout);
  requireNotNegative("oscillation_distance", oscillation_distance);
  requireNotNegative("conservative_reset_dist", conservative_reset_dist);
  requirePositive("xy_goal_tolerance", goal_tolerance.distance);
  requirePositive("yaw_goal_tolerance", goal_tolerance.yaw);
  requirePositive("via_xy_tolerance", via_tolerance.distance);
  requirePositive("via_yaw_tolerance", via_tolerance.yaw);
  requireNotNegative("coast_time", coast_time);
  planner.validate();
  follower.validate();
  const double least = follower.limits.wheelbase / std::tan(follower.max_steering_angle);
  requireOption(
    planner.min_turning_radius >= least, "min_turning_radius", planner.min_turning_radius,
    "at least wheelbase / tan(max_steering_angle) = " + std::to_string(least));
}

Navigator::Navigator(const NavigatorOptions & options)
: options_(options),
  planner_(options.planner),
  follower_(options.follower),
  behaviors_(recoveryBehaviors(options.clearing_rotation_allowed))
{
  options_.validate();
}

void Navigator::setGoal(const Pose2 & goal, double time, std::vector<Pose2> next)
{
  goals_.set(goal, std::move(next));
  state_ = State::kPlanning;
  recovery_index_ = 0;
  planning_retries_ = 0;
  no_plan_because_.clear();
  last_valid_plan_ = last_valid_control_ = last_oscillation_reset_ = next_plan_ = next_passing_ = time;
  oscillation_pose_.reset();
  previous_pose_.reset();
  coast_until_.reset();
  stop_until_ = 0.0;
}

void Navigator::setNextGoals(std::vector<Pose2> next)
{
  const bool passed = passes();
  goals_.setNext(std::move(next));
  if (passes() != passed && state_ == State::kControlling) {
    state_ = State::kPlanning;
    next_plan_ = previous_time_.value_or(0.0);
  }
}

void Navigator::cancel()
{
  goals_.clear();
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
    reckoning_.clear();
    stop_until_ = 0.0;
  }
  CycleInput now = input;
  const double seen = input.time - input.age;
  const double measured = input.sensors_current ? seen : input.time - input.speed_age;
  now.car = reckoning_.predict(input.car, seen, measured, input.time);
  CycleOutput output;
  drive(now, costmap, output);
  if (active() && !no_plan_because_.empty()) {
    output.trouble = no_plan_because_;
  }
  previous_time_ = now.time;
  previous_pose_ = now.car.pose;
  reckoning_.note(now.time, output.command.value_or(DriveCommand{}));
  return output;
}

void Navigator::drive(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  if (!input.sensors_current) {
    if (goals_.any() || coast_until_) {
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
  if (std::abs(input.car.speed) < kStandingSpeed) {
    output.command = DriveCommand{};
    next_plan_ = last_valid_plan_ = last_valid_control_ = input.time;
    state_ = state_ == State::kControlling ? State::kPlanning : state_;
  } else {
    hold(input, costmap, output);
  }
}

Plan Navigator::makePlan(const Costmap & costmap, const Pose2 & start, const Pose2 & goal) const
{
  return planner_.plan(costmap, {start, goal, 0.0, 0.0});
}

void Navigator::pursue(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  watchOscillation(input);
  watchProgress(input);
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
  if (input.time < next_plan_) {
    hold(input, costmap, output);
    return;
  }
  next_plan_ = input.time + kRetryInterval;
  const PlanRequest request = requestFrom(input.car);
  Plan plan = planner_.plan(costmap, request);
  if (!plan.found()) {
    planFailed(obstructionOf(costmap, request, plan.status), input, costmap, output);
    return;
  }
  if (follower_.hasPath() && !canDrive(plan, input.car, costmap)) {
    hold(input, costmap, output);
    return;
  }
  plan_ = std::move(plan);
  plan_races_ = request.race_line.has_value();
  no_plan_because_.clear();
  output.new_plan = true;
  planning_retries_ = 0;
  last_valid_plan_ = next_passing_ = input.time;
  follower_.setPath(plan_.path, costmap);
  state_ = State::kControlling;
  control(input, costmap, output);
}

// A car that is too fast for a new plan, or would have to turn round, brakes along the old one first.
bool Navigator::canDrive(const Plan & plan, const CarState & car, const Costmap & costmap) const
{
  if (car.speed < kTooFast) {
    return true;
  }
  const auto nearest = std::min_element(
    plan.path.begin(), plan.path.end(),
    [&](const PathPoint & a, const PathPoint & b) { return distance(a.pose, car.pose) < distance(b.pose, car.pose); });
  const std::vector<double> speeds = speedProfile(plan.path, costmap, options_.follower.limits);
  return !plan.path.front().reverse && car.speed <= speeds[static_cast<std::size_t>(nearest - plan.path.begin())] +
                                                      (passes() ? kFarTooFast : kTooFast);
}

PlanRequest Navigator::requestFrom(const CarState & car) const
{
  const double curvature = follower_.lastCommand().curvature;
  PlanRequest request{advance(car.pose, car.speed * options_.follower.latency, curvature), goals_.front(), curvature};
  if (passes()) {
    request.extension_length = extensionLength();
  }
  if (races(car)) {
    const SpeedLimits & limits = options_.follower.limits;
    request.race_line = RaceLineOptions{
      kGatePart * tolerance().distance, options_.follower.slip_gradient, limits.max_lateral_acceleration,
      limits.max_vel_x};
  }
  if (options_.race_line) {
    request.lead = follower_.lead(car, options_.follower.latency + kLeadTime);
  }
  if (!request.lead.empty()) {
    request.start = request.lead.back().pose;
    request.start_curvature = request.lead.back().curvature;
  }
  return request;
}

void Navigator::planFailed(
  const Obstruction & obstruction, const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  no_plan_because_ = obstruction.reason;
  if (obstruction.lasting) {
    giveUp("Failed to find a valid plan. " + obstruction.reason, input, costmap, output);
    return;
  }
  ++planning_retries_;
  const bool spent = options_.max_planning_retries >= 0 && planning_retries_ > options_.max_planning_retries;
  if (spent || input.time > last_valid_plan_ + options_.planner_patience) {
    recover(Trigger::kPlanning, input, costmap, output);
  } else {
    hold(input, costmap, output);
  }
}

// A car that drives comes to a stand along the path that it has.
void Navigator::giveUp(
  const std::string & text, const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  goals_.clear();
  output.outcome = Outcome{false, text};
  if (std::abs(input.car.speed) > kStandingSpeed && follower_.hasPath()) {
    coast_until_ = input.time;
    coast(input, costmap, output);
  } else {
    output.command = DriveCommand{};
    stop();
  }
}

void Navigator::control(const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  const std::vector<Forecast> others = forecasts(costmap, input.time);
  passIfHindered(input, costmap, others, output);
  FollowStep step = follower_.step(input.car, costmap, period(input.time), false, others);
  output.command = step.command;
  if (finishIfReached(input, output)) {
    return;
  }
  output.prediction = std::move(step.prediction);
  if (step.stuck) {
    output.trouble = "Something stands in the car's way.";
  }
  if (!step.lost && !step.stuck) {
    last_valid_control_ = input.time;
  }
  if (options_.oscillation_timeout > 0.0 && input.time > last_oscillation_reset_ + options_.oscillation_timeout) {
    recover(Trigger::kOscillation, input, costmap, output);
  } else if (input.time > last_valid_control_ + options_.controller_patience) {
    recover(Trigger::kControlling, input, costmap, output);
  } else if (needsPlan(input, step)) {
    state_ = State::kPlanning;
  }
}

void Navigator::passIfHindered(
  const CycleInput & input, const Costmap & costmap, const std::vector<Forecast> & others, CycleOutput & output)
{
  if (input.time < next_passing_ || !follower_.hindered(input.car, costmap, others)) {
    return;
  }
  next_passing_ = input.time + kPassingInterval;
  const PlanRequest request = requestFrom(input.car);
  if (request.lead.empty() || !request.race_line) {
    return;
  }
  auto plan = planPast(
    {costmap, options_.planner, options_.follower.limits, plan_, request, others, follower_.placeOf(input.car),
     input.car.speed});
  if (plan) {
    plan_ = std::move(*plan);
    output.new_plan = true;
    follower_.setPath(plan_.path, costmap);
  }
}

bool Navigator::needsPlan(const CycleInput & input, const FollowStep & step) const
{
  if (input.time < next_plan_) {
    return false;
  }
  const bool approaches = plan_races_ && !passes() && plan_.goal_s - step.position.s < approachLength(input.car.speed);
  const bool passed = step.position.s > plan_.goal_s + tolerance().distance;
  const bool due =
    options_.planner_frequency > 0.0 && input.time >= last_valid_plan_ + 1.0 / options_.planner_frequency;
  const bool missed = step.at_end && std::abs(input.car.speed) < kStandingSpeed;
  return step.lost || step.blocked || missed || passed || approaches || due;
}

bool Navigator::finishIfReached(const CycleInput & input, CycleOutput & output)
{
  const Pose2 & before = previous_pose_.value_or(input.car.pose);
  const bool stands = std::abs(input.car.speed) < kStandingSpeed;
  if (!cameNear(before, input.car.pose, goals_.front(), tolerance()) || !(passes() || stands)) {
    return false;
  }
  output.outcome = Outcome{true, "Goal reached."};
  if (passes()) {
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
  FollowStep step =
    follower_.step(input.car, costmap, period(input.time), input.time >= *coast_until_, forecasts(costmap, input.time));
  output.command = step.command;
  output.prediction = std::move(step.prediction);
  if (std::abs(input.car.speed) < kStandingSpeed && step.command.speed == 0.0) {
    cancel();
  }
}

// Without a plan for the new goal the car comes to a stand along the old one, not wherever its wheels point.
void Navigator::hold(const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  output.command =
    follower_.hasPath() ? follower_.step(input.car, costmap, period(input.time), true).command : DriveCommand{};
}

void Navigator::recover(Trigger trigger, const CycleInput & input, Costmap & costmap, CycleOutput & output)
{
  recovery_pose_ = input.car.pose;
  output.command = DriveCommand{};
  stop();
  if (!options_.recovery_behavior_enabled || recovery_index_ >= behaviors_.size()) {
    goals_.clear();
    output.outcome = Outcome{false, failureOf(trigger)};
    return;
  }
  const RecoveryBehavior behavior = behaviors_[recovery_index_];
  output.recovery = RecoveryNotice{recovery_index_, static_cast<unsigned>(behaviors_.size()), nameOf(behavior)};
  ++recovery_index_;
  begin(behavior, input, costmap);
}

void Navigator::begin(RecoveryBehavior behavior, const CycleInput & input, Costmap & costmap)
{
  if (behavior == RecoveryBehavior::kBackUp) {
    back_up_ = BackUp(input.car.pose, input.time);
    state_ = State::kBackingUp;
    return;
  }
  const bool conservative = behavior == RecoveryBehavior::kConservativeReset;
  costmap.forgetBeyond(input.car.pose.position(), conservative ? options_.conservative_reset_dist : 0.0);
  endRecovery(input.time);
}

void Navigator::driveBack(const CycleInput & input, const Costmap & costmap, CycleOutput & output)
{
  const double speed = options_.follower.limits.max_vel_x_backwards;
  output.command = back_up_->step(input.car.pose, input.time, speed, costmap);
  if (!output.command) {
    output.command = DriveCommand{};
    endRecovery(input.time);
  }
}

void Navigator::endRecovery(double time)
{
  state_ = State::kPlanning;
  planning_retries_ = 0;
  last_valid_plan_ = last_oscillation_reset_ = next_plan_ = time;
}

void Navigator::watchOscillation(const CycleInput & input)
{
  if (oscillation_pose_ && distance(*oscillation_pose_, input.car.pose) < options_.oscillation_distance) {
    return;
  }
  oscillation_pose_ = input.car.pose;
  last_oscillation_reset_ = input.time;
}

// Recovery has helped when the car gets farther than recovery itself has moved it.
void Navigator::watchProgress(const CycleInput & input)
{
  if (recovery_index_ > 0 && distance(recovery_pose_, input.car.pose) > kProgress) {
    recovery_index_ = 0;
  }
}

std::string Navigator::failureOf(Trigger trigger) const
{
  switch (trigger) {
    case Trigger::kPlanning:
      return "Failed to find a valid plan. Even after executing recovery behaviors. " + no_plan_because_;
    case Trigger::kControlling:
      return "Failed to find a valid control. Even after executing recovery behaviors.";
    case Trigger::kOscillation:
      return "Robot is oscillating. Even after executing recovery behaviors.";
  }
  return "";
}

// A race line does not end as a goal says: the last way is planned to the goal itself.
bool Navigator::races(const CarState & car) const
{
  const bool far = distance(car.pose, goals_.front()) > approachLength(car.speed) + kApproachMargin;
  return options_.free_goal_vel && options_.race_line && (goals_.anyNext() || far);
}

double Navigator::approachLength(double speed) const
{
  return options_.follower.limits.brakingDistance(speed) + kApproachLength;
}

double Navigator::extensionLength() const
{
  const SpeedLimits & limits = options_.follower.limits;
  const double longest =
    limits.brakingDistance(limits.max_vel_x) + limits.max_vel_x * options_.coast_time + kExtensionMargin;
  return std::min(longest, goals_.wayToLast());
}

double Navigator::period(double time) const
{
  return previous_time_ ? std::clamp(time - *previous_time_, 0.0, kLongestPeriod) : 0.0;
}
}  // namespace move_base
