#include "control/path_follower.h"

#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>

namespace move_base
{
namespace
{
constexpr double kEndReached = 0.03;      // m
constexpr double kPredictionStep = 0.05;  // s
constexpr double kPredictionTime = 0.8;   // s beyond the time needed for braking
constexpr double kBrakingReserve = 1.5;   // of the deceleration of the speed profile, to come down to a slower profile
constexpr double kSlipStep = 0.03;        // part by which the slip must change to be taken into account
constexpr double kUsualSlip = 1.15;       // times what it is told to be, up to which the grip is that of a dry road
constexpr double kSlipPower = 1.5;        // of the slip beyond: on average it is measured before it is all there
constexpr double kUsualTraction = 0.9;    // of the acceleration told, from which the grip is that of a dry road
constexpr double kSpinning = 0.85;        // of what spinning wheels pass on, that they do while they steer as well
constexpr double kUnfelt = 0.6;       // of the lateral acceleration planned, until a bend has shown how the tyres slip
constexpr double kStopMargin = 0.05;  // m, left before an obstacle
constexpr double kBends = 0.25;       // of the lateral acceleration, from which braking is limited for it
constexpr double kLeastLeft = 0.35;   // of the acceleration, however hard the car corners
// A Twist without speed says nothing of the wheels: they would straighten while the car still rolls, m/s.
constexpr double kCreep = 1e-3;
// The speed commanded and the speed measured may differ by this much before the slew starts from the measured one, m/s.
constexpr double kSpeedSlack = 0.5;
constexpr double kSlackPart = 1.3;  // of what the speed lags behind when the car speeds up as it may
// Beyond this angle between car and path, steering back does not work, rad.
constexpr double kMaxHeadingError = 1.2;

bool drivesForwards(const PathPosition & here, const CarState & car)
{
  return !here.reverse && car.speed >= 0.0;
}
}  // namespace

void FollowerOptions::validate() const
{
  limits.validate();
  requireOption(
    max_steering_angle > 0.0 && max_steering_angle < 0.5 * M_PI, "max_steering_angle", max_steering_angle,
    "above 0 and below pi/2");
  requireNotNegative("latency", latency);
  requirePositive("tracking_distance", tracking_distance);
  requireNotNegative("tracking_time", tracking_time);
  requireNotNegative("slip_gradient", slip_gradient);
  requireNotNegative("understeer_gradient", understeer_gradient);
  const double utmost = 1.0 / std::max(limits.acc_lim_x, limits.dec_lim_x);
  requireOption(
    load_transfer >= 0.0 && load_transfer < utmost, "load_transfer", load_transfer,
    "at least 0 and below 1 / (greater of acc_lim_x and dec_lim_x) = " + std::to_string(utmost));
  requireNotNegative("yaw_lag", yaw_lag);
  requireNotNegative("stop_clearance", stop_clearance);
  requireNotNegative("replan_distance", replan_distance);
  requirePositive("max_path_deviation", max_path_deviation);
}

PathFollower::PathFollower(const FollowerOptions & options)
: given_(options),
  options_(options),
  lags_{options.latency, kSpeedLag + options.latency},
  grip_to_side_(options.limits.max_lateral_acceleration)
{
  options_.validate();
}

void PathFollower::setPath(const Path & path, const Costmap & costmap, const Caution & caution)
{
  path_ = path;
  caution_ = caution;
  speeds_ = speedProfile(path_, costmap, options_.limits, caution_);
  tracker_ = PathTracker(path_);
}

void PathFollower::setTyres(const Tyres & tyres, const Costmap & costmap)
{
  const bool same_slip = std::abs(tyres.slip - tyres_.slip) < kSlipStep * tyres_.slip;
  const bool same_traction = std::abs(tyres.traction - tyres_.traction) < kSlipStep * tyres_.traction;
  if (same_slip && same_traction && tyres.felt == tyres_.felt) {
    return;
  }
  tyres_ = tyres;
  options_.slip_gradient = given_.slip_gradient * tyres.slip;
  options_.understeer_gradient = given_.understeer_gradient * tyres.slip;
  options_.yaw_lag = given_.yaw_lag * tyres.slip;
  const double passed_on = tyres.traction < kUsualTraction ? kSpinning * tyres.traction : 1.0;
  const double grip = std::min(passed_on, std::pow(kUsualSlip / tyres.slip, kSlipPower));
  options_.limits.acc_lim_x = given_.limits.acc_lim_x * grip;
  options_.limits.dec_lim_x = given_.limits.dec_lim_x * grip;
  options_.limits.braking_power = given_.limits.braking_power * grip;
  grip_to_side_ = given_.limits.max_lateral_acceleration * grip;
  options_.limits.max_lateral_acceleration =
    tyres.felt ? grip_to_side_ : std::min(grip_to_side_, kUnfelt * given_.limits.max_lateral_acceleration);
  speeds_ = speedProfile(path_, costmap, options_.limits, caution_);
}

void PathFollower::clear()
{
  path_.clear();
  speeds_.clear();
  last_ = {};
  last_bend_ = 0.0;
}

Path PathFollower::lead(const CarState & car, double time) const
{
  constexpr double kMaxOffset = 0.3;       // m
  constexpr double kMaxHeading = 0.5;      // rad
  constexpr double kLeastLeadSpeed = 0.2;  // m/s: also who creeps behind another looks for a way past it
  if (path_.empty() || car.speed < kLeastLeadSpeed) {
    return {};
  }
  const PathPosition here = tracker_.locate(path_, car.pose);
  const double until = here.s + car.speed * time;
  const bool on_path = std::abs(here.lateral) < kMaxOffset && std::abs(here.heading_error) < kMaxHeading;
  if (here.reverse || !on_path || until > here.s + here.remaining) {
    return {};
  }
  const auto first = path_.begin() + static_cast<std::ptrdiff_t>(here.index);
  const auto last = std::find_if(first, path_.end(), [&](const PathPoint & point) { return point.s >= until; });
  return last == path_.end() ? Path{} : Path(first, std::next(last));
}

bool PathFollower::canDriveOn(const CarState & car) const
{
  constexpr double kReserve = 1.0;  // m
  return tracker_.locate(path_, car.pose).remaining > options_.limits.brakingDistance(car.speed) + kReserve;
}

bool PathFollower::hindered(const CarState & car, const Costmap & costmap, const std::vector<Forecast> & others) const
{
  const PathPosition here = tracker_.locate(path_, car.pose);
  return drivesForwards(here, car) && isHindered(wayFrom(here, car, costmap), others);
}

OwnWay PathFollower::wayFrom(const PathPosition & here, const CarState & car, const Costmap & costmap) const
{
  return {path_, speeds_, options_.limits, costmap.footprint(), {here.s, here.lateral, car.speed}};
}

FollowStep PathFollower::step(
  const CarState & car, const Costmap & costmap, double period, bool brake, const std::vector<Forecast> & others)
{
  changeDirectionWhenStanding(car);
  noteSent(period);
  FollowStep result;
  result.position = tracker_.moveTo(path_, car.pose);
  result.lost = std::abs(result.position.lateral) > options_.max_path_deviation ||
                std::abs(result.position.heading_error) > kMaxHeadingError;
  result.at_end = tracker_.onLastStretch() && result.position.remaining <= kEndReached;
  const PathPosition predicted = tracker_.locate(path_, afterLatency(car));

  const double free = distanceToObstacle(car, costmap, result.prediction);
  const double stoppable = options_.limits.speedToStopWithin(free - kStopMargin - std::abs(car.speed) * lags_.speed);
  result.stuck = stoppable < kStandingSpeed;
  result.blocked = result.stuck || pathBlocked(result.position, car.speed, costmap);

  const bool stop = brake || result.lost || result.position.remaining <= kEndReached;
  const SpeedBehind behind = drivesForwards(result.position, car)
                               ? speedBehindOthers(wayFrom(result.position, car, costmap), others)
                               : SpeedBehind{};
  const double utmost = std::min(stoppable, behind.utmost);
  const double bend = steer(predicted, curvatureAhead(predicted, car.speed), std::abs(car.speed));
  const double speed =
    stop ? 0.0 : std::min({wantedSpeed(predicted, car.speed), speedFor(bend), utmost, behind.wanted});
  const double slow = slewed(result.position.reverse ? -speed : speed, car.speed, brake, period);
  const double gentle = gentlest(car);
  result.command.speed = std::clamp(slow, -std::max(stoppable, gentle), std::max(utmost, gentle));
  if (!car.stands() && std::abs(result.command.speed) < kCreep) {
    result.command.speed = std::copysign(kCreep, car.speed);
  }
  last_bend_ = drivable(bend, std::abs(car.speed));
  result.command.curvature = withUndersteer(last_bend_, car.speed, accelerationTo(result.command.speed, car.speed));
  last_ = result.command;
  return result;
}

double PathFollower::maxCurvature() const
{
  return std::tan(options_.max_steering_angle) / options_.limits.wheelbase;
}

// Of a curvature, 1/m, what wheels and tyres allow.
double PathFollower::drivable(double curvature, double speed) const
{
  const double limit = std::min(maxCurvature(), grip_to_side_ / std::max(speed * speed, 1e-6));
  return std::clamp(curvature, -limit, limit);
}

// At which the tyres hold the car on a curvature: one that has left its path in a bend comes back only if it slows down.
double PathFollower::speedFor(double curvature) const
{
  const double bend = std::min(std::abs(curvature), maxCurvature());
  return std::max(options_.limits.speedInBend(bend), options_.limits.min_vel_x);
}

// m/s^2, that the tyres can bring about.
double PathFollower::lateralOn(double curvature, double speed) const
{
  return std::clamp(speed * speed * curvature, -grip_to_side_, grip_to_side_);
}

double PathFollower::slipOn(double curvature, double speed) const
{
  return options_.slip_gradient * lateralOn(curvature, speed);
}

// Of its acceleration, what the tyres have left that hold a car in a bend: braking with more than that, its tail comes
// round, and speeding up with more, its front axle loses the load that it steers with.
double PathFollower::leftInBend(double speed, double bend) const
{
  return std::max(options_.limits.leftInBend(speed, bend), kLeastLeft);
}

// Not slower than this, whatever a car in a bend brakes for: who spins does not stop sooner. It is in a bend for as long
// as it turns, whatever its wheels are told.
double PathFollower::gentlest(const CarState & car) const
{
  const double speed = std::abs(car.speed);
  const double turns = std::abs(car.yaw_rate) / std::max(speed, kStandingSpeed);
  const double bend = std::max(std::abs(last_bend_), turns);
  if (speed * speed * bend <= kBends * options_.limits.max_lateral_acceleration) {
    return 0.0;
  }
  return speed - leftInBend(speed, bend) * options_.limits.deceleration(speed) * lags_.speed;
}

// By how much the car speeds up, its speed lagging behind the command.
double PathFollower::accelerationTo(double command, double speed) const
{
  const double gain = (std::abs(command) - std::abs(speed)) / lags_.speed;
  return std::clamp(gain, -options_.limits.deceleration(speed), options_.limits.acc_lim_x);
}

// An axle's slip grows with its lateral force over its load.
double PathFollower::withUndersteer(double curvature, double speed, double acceleration) const
{
  const double lateral = lateralOn(curvature, speed);
  const double shift = options_.load_transfer * acceleration;
  const double front = (options_.slip_gradient + options_.understeer_gradient) / (1.0 - shift);
  const double rear = options_.slip_gradient / (1.0 + shift);
  const double wheelbase = options_.limits.wheelbase;
  const double angle = std::atan(wheelbase * curvature) + (front - rear) * lateral;
  return std::tan(std::clamp(angle, -options_.max_steering_angle, options_.max_steering_angle)) / wheelbase;
}

// What has been commanded within the latency is still to come.
Pose2 PathFollower::afterLatency(const CarState & car) const
{
  const double slip = slipOn(last_bend_, car.speed);
  Pose2 pose{car.pose.x, car.pose.y, car.pose.yaw - slip};
  double left = lags_.latency;
  for (const Sent & sent : sent_) {
    pose = advance(pose, car.speed * std::min(sent.duration, left), sent.bend);
    left -= std::min(sent.duration, left);
  }
  pose = advance(pose, car.speed * left, last_bend_);
  pose.yaw += slip;
  return pose;
}

void PathFollower::noteSent(double period)
{
  sent_.push_back({period, last_bend_});
  double held = 0.0;
  for (const Sent & sent : sent_) {
    held += sent.duration;
  }
  while (!sent_.empty() && held - sent_.front().duration >= lags_.latency) {
    held -= sent_.front().duration;
    sent_.pop_front();
  }
  if (!sent_.empty() && held > lags_.latency) {
    sent_.front().duration -= held - lags_.latency;
  }
}

// Makes the lateral error decay along the way like a critically damped spring, on top of the curvature, 1/m, wanted
// ahead. Slip is that of the path: that of the last command would feed back on itself and make the car weave.
double PathFollower::steer(const PathPosition & position, double ahead, double speed) const
{
  const double reach = options_.tracking_distance + options_.tracking_time * speed;
  const double way = position.reverse ? -1.0 : 1.0;
  const double stretch = std::max(0.2, 1.0 - way * position.curvature * position.lateral);
  const double astray = position.heading_error - slipOn(position.curvature, speed);
  return ahead * std::cos(astray) / stretch -
         way * (position.lateral / (reach * reach) + 2.0 * std::sin(astray) / reach);
}

// Of the path where the car will be when its yaw has followed the wheels.
double PathFollower::curvatureAhead(const PathPosition & position, double speed) const
{
  const double until = position.s + options_.yaw_lag * speed * speed;
  std::size_t i = position.index;
  while (i + 1 < path_.size() && path_[i + 1].s < until && path_[i + 1].reverse == position.reverse) {
    ++i;
  }
  return path_[i].curvature;
}

double PathFollower::profileAt(double s, std::size_t from) const
{
  std::size_t i = from;
  while (i + 1 < path_.size() && path_[i + 1].s < s) {
    ++i;
  }
  if (i + 1 >= path_.size()) {
    return speeds_.back();
  }
  const double step = path_[i + 1].s - path_[i].s;
  const double part = step > 0.0 ? std::clamp((s - path_[i].s) / step, 0.0, 1.0) : 0.0;
  return speeds_[i] + part * (speeds_[i + 1] - speeds_[i]);
}

double PathFollower::wantedSpeed(const PathPosition & position, double speed) const
{
  const double lead = std::min(std::abs(speed) * lags_.speed, position.remaining);
  const double here = profileAt(position.s, position.index);
  const double soon = profileAt(position.s + lead, position.index);
  return std::max(std::min(here, soon), options_.limits.min_vel_x);
}

// Drives on in thought, as the next steps would: the way until the car would touch something, m.
double PathFollower::distanceToObstacle(
  const CarState & car, const Costmap & costmap, std::vector<Pose2> & prediction) const
{
  const double here = costmap.clearance(car.pose);
  const double time = kPredictionTime + std::abs(car.speed) / options_.limits.deceleration(car.speed);
  PathTracker tracker = tracker_;
  Pose2 pose = car.pose;
  double pace = std::abs(car.speed);
  double driven = 0.0;
  for (double t = 0.0; t < time; t += kPredictionStep) {
    const PathPosition position = tracker.moveTo(path_, pose);
    if (position.remaining <= kEndReached) {
      break;
    }
    const double slower = pace - options_.limits.deceleration(pace) * kPredictionStep;
    pace = std::max({std::min(pace, profileAt(position.s, position.index)), slower, options_.limits.min_vel_x});
    const double distance = std::min(pace * kPredictionStep, position.remaining);
    const double bend = drivable(steer(position, position.curvature, pace), pace);
    const double slip = slipOn(position.curvature, pace);
    pose = advance({pose.x, pose.y, pose.yaw - slip}, position.reverse ? -distance : distance, bend);
    pose.yaw += slip;
    prediction.push_back(pose);
    // A car that stands closer to something already may drive away from it.
    if (costmap.clearance(pose) < std::min(options_.stop_clearance, here - 0.01)) {
      return driven;
    }
    driven += distance;
  }
  return HUGE_VAL;
}

bool PathFollower::pathBlocked(const PathPosition & position, double speed, const Costmap & costmap) const
{
  const double until = position.s + options_.replan_distance + options_.limits.brakingDistance(speed);
  const double here = costmap.clearance(path_[position.index].pose);
  for (std::size_t i = position.index; i < path_.size() && path_[i].s <= until; ++i) {
    if (costmap.clearance(path_[i].pose) < std::min(0.0, here - 0.01)) {
      return true;
    }
  }
  return false;
}

void PathFollower::changeDirectionWhenStanding(const CarState & car)
{
  const PathPosition position = tracker_.locate(path_, car.pose);
  if (position.remaining <= kEndReached && car.stands()) {
    tracker_.nextStretch();
  }
}

double PathFollower::slewed(double wanted, double speed, bool brake, double period) const
{
  const double left = leftInBend(speed, last_bend_);
  const double greatest = std::max(options_.limits.acc_lim_x, options_.limits.dec_lim_x);
  const double slack = std::max(kSpeedSlack, kSlackPart * lags_.speed * greatest);
  const double from = std::clamp(last_.speed, speed - slack, speed + slack);
  const bool slower = std::abs(wanted) < std::abs(from) || wanted * from < 0.0;
  const double braking =
    std::min(options_.limits.dec_lim_x, kBrakingReserve * (brake ? left : 1.0) * options_.limits.deceleration(from));
  const double step = (slower ? braking : left * options_.limits.acc_lim_x) * period;
  return from + std::clamp(wanted - from, -step, step);
}
}  // namespace move_base
