#include "control/path_follower.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kEndReached = 0.03;      // m
constexpr double kReplanDistance = 2.5;   // m beyond the braking distance, up to which an obstacle leads to a new plan
constexpr double kPredictionStep = 0.05;  // s
constexpr double kPredictionTime = 0.8;   // s beyond the time needed for braking
constexpr double kBrakingReserve = 1.5;   // of the deceleration of the speed profile, to come down to a slower profile
constexpr double kStopMargin = 0.05;      // m, left before an obstacle
// A Twist without speed does not set the wheels: they would straighten while the car still rolls, m/s.
constexpr double kCreep = 1e-3;
constexpr double kUnturned = 0.1;  // rad, still to be turned by the wheels: a car that set off would leave its path
// The speed commanded and the speed measured may differ by this much before the slew starts from the measured one, m/s.
constexpr double kSpeedSlack = 0.5;
constexpr double kSlackPart = 1.3;    // of what the speed lags behind when the car speeds up as hard as it may
constexpr double kLongestLead = 2.0;  // m, of the steering
// Beyond this angle between car and path, steering back does not work, rad.
constexpr double kMaxHeadingError = 1.2;

bool drivesForwards(const PathPosition & here, const CarState & car)
{
  return !here.reverse && car.speed >= 0.0;
}
}  // namespace

PathFollower::PathFollower(const FollowerOptions & options) : handling_(options) {}

void PathFollower::setPath(const Path & path, const Costmap & costmap, const Caution & caution)
{
  path_ = path;
  caution_ = caution;
  speeds_ = speedProfile(path_, costmap, options().limits, caution_);
  tracker_ = PathTracker(path_);
}

void PathFollower::setHandling(const Lags & lags, const Tyres & tyres, const Costmap & costmap)
{
  if (handling_.set(lags, tyres)) {
    speeds_ = speedProfile(path_, costmap, options().limits, caution_);
  }
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
  constexpr double kLeastLeadSpeed = 0.2;  // m/s: a car that creeps behind another looks for a way past it, too
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
  return tracker_.locate(path_, car.pose).remaining > options().limits.brakingDistance(car.speed) + kReserve;
}

bool PathFollower::hindered(const CarState & car, const Costmap & costmap, const std::vector<Forecast> & others) const
{
  const PathPosition here = tracker_.locate(path_, car.pose);
  return drivesForwards(here, car) && isHindered(wayFrom(here, car, costmap), others);
}

OwnWay PathFollower::wayFrom(const PathPosition & here, const CarState & car, const Costmap & costmap) const
{
  return {path_, speeds_, options().limits, costmap.footprint(), {here.s, here.lateral, car.speed}, options().traffic};
}

FollowStep PathFollower::step(
  const CarState & car, const Costmap & costmap, double period, bool brake, const std::vector<Forecast> & others)
{
  changeDirectionWhenStanding(car);
  noteSent(period);
  FollowStep result;
  result.position = tracker_.moveTo(path_, car.pose);
  result.lost =
    std::abs(result.position.lateral) > kMaxDeviation || std::abs(result.position.heading_error) > kMaxHeadingError;
  result.at_end = tracker_.onLastStretch() && result.position.remaining <= kEndReached;
  const PathPosition predicted = tracker_.locate(path_, afterLatency(car));

  const double free = distanceToObstacle(car, costmap, result.prediction);
  const double stoppable = options().limits.speedToStopWithin(free - kStopMargin - std::abs(car.speed) * lags().speed);
  result.stuck = stoppable < kStandingSpeed;
  result.blocked = result.stuck || pathBlocked(result.position, car.speed, costmap);

  const bool stop = brake || result.lost || result.position.remaining <= kEndReached;
  const SpeedBehind behind = drivesForwards(result.position, car)
                               ? speedBehindOthers(wayFrom(result.position, car, costmap), others)
                               : SpeedBehind{};
  const double utmost = std::min(stoppable, behind.utmost);
  const double bend = steer(predicted, curvatureAhead(predicted, car.speed), std::abs(car.speed));
  const double speed =
    stop ? 0.0 : std::min({wantedSpeed(predicted, car.speed), handling_.speedFor(bend), utmost, behind.wanted});
  const double slow = slewed(result.position.reverse ? -speed : speed, car.speed, brake, period);
  const double gentle = handling_.gentlest(car, last_bend_);
  result.command.speed = std::clamp(slow, -std::max(stoppable, gentle), std::max(utmost, gentle));
  if (!car.stands() && std::abs(result.command.speed) < kCreep) {
    result.command.speed = std::copysign(kCreep, car.speed);
  }
  last_bend_ = handling_.drivable(bend, std::abs(car.speed));
  result.command.curvature = handling_.withUndersteer(last_bend_, predicted.curvature, car.speed, result.command.speed);
  const double unturned = std::abs(options().limits.wheelAngle(result.command.curvature) - wheels_);
  if (car.stands() && unturned > kUnturned) {
    result.command.speed = std::clamp(result.command.speed, -kCreep, kCreep);
  }
  last_ = result.command;
  return result;
}

// What has been commanded within the latency has yet to take effect.
Pose2 PathFollower::afterLatency(const CarState & car) const
{
  const double slip = handling_.slipOn(last_bend_, car.speed);
  Pose2 pose{car.pose.x, car.pose.y, car.pose.yaw - slip};
  double left = lags().latency;
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
  const double farthest = options().limits.max_steering_rate * period;
  wheels_ += std::clamp(last_.steeringAngle(options().limits.wheelbase) - wheels_, -farthest, farthest);
  sent_.push_back({period, last_bend_});
  double held = 0.0;
  for (const Sent & sent : sent_) {
    held += sent.duration;
  }
  while (!sent_.empty() && held - sent_.front().duration >= lags().latency) {
    held -= sent_.front().duration;
    sent_.pop_front();
  }
  if (!sent_.empty() && held > lags().latency) {
    sent_.front().duration -= held - lags().latency;
  }
}

// Makes the lateral error decay along the way like a critically damped spring, on top of the curvature, 1/m, wanted
// ahead. Slip is that of the path: that of the last command would feed back on itself and make the car weave.
double PathFollower::steer(const PathPosition & position, double ahead, double speed) const
{
  const double reach = options().tracking_distance + options().tracking_time * speed;
  const double way = position.reverse ? -1.0 : 1.0;
  const double stretch = std::max(0.2, 1.0 - way * position.curvature * position.lateral);
  const double astray = position.heading_error - handling_.slipOn(position.curvature, speed);
  return ahead * maths::cos(astray) / stretch -
         way * (position.lateral / (reach * reach) + 2.0 * maths::sin(astray) / reach);
}

// Curvature of the path where the car will be when its yaw has followed the wheels, at the speeds that it will drive.
// Before a kink the wheels begin to turn so early that half of the turn is done there.
double PathFollower::curvatureAhead(const PathPosition & position, double speed) const
{
  const SpeedLimits & limits = options().limits;
  const double here = limits.wheelAngle(path_[position.index].curvature);
  double ahead = position.curvature;
  double time = 0.0;
  double before = position.s;
  for (std::size_t i = position.index + 1; i < path_.size() && path_[i].reverse == position.reverse; ++i) {
    const double then = std::max(std::min(std::abs(speed), speeds_[i]), kCreep);
    time += (path_[i].s - before) / then;
    before = path_[i].s;
    const double turn = std::abs(limits.wheelAngle(path_[i].curvature) - here);
    if (time < options().yaw_lag * then + 0.5 * turn / limits.max_steering_rate) {
      ahead = path_[i].curvature;
    } else if (before > position.s + kLongestLead) {
      break;
    }
  }
  return ahead;
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
  const double lead = std::min(std::abs(speed) * lags().speed, position.remaining);
  const double here = profileAt(position.s, position.index);
  const double soon = profileAt(position.s + lead, position.index);
  return std::max(std::min(here, soon), options().limits.min_vel_x);
}

// Simulates driving on, as the next steps would: the way until the car would touch something, m.
double PathFollower::distanceToObstacle(
  const CarState & car, const Costmap & costmap, std::vector<Pose2> & prediction) const
{
  const double here = costmap.clearance(car.pose);
  const double time = kPredictionTime + std::abs(car.speed) / options().limits.deceleration(car.speed);
  PathTracker tracker = tracker_;
  Pose2 pose = car.pose;
  double pace = std::abs(car.speed);
  double driven = 0.0;
  for (double t = 0.0; t < time; t += kPredictionStep) {
    const PathPosition position = tracker.moveTo(path_, pose);
    if (position.remaining <= kEndReached) {
      break;
    }
    const double slower = pace - options().limits.deceleration(pace) * kPredictionStep;
    pace = std::max({std::min(pace, profileAt(position.s, position.index)), slower, options().limits.min_vel_x});
    const double distance = std::min(pace * kPredictionStep, position.remaining);
    const double bend = handling_.drivable(steer(position, position.curvature, pace), pace);
    const double slip = handling_.slipOn(position.curvature, pace);
    pose = advance({pose.x, pose.y, pose.yaw - slip}, position.reverse ? -distance : distance, bend);
    pose.yaw += slip;
    prediction.push_back(pose);
    // A car that already stands closer to something may drive away from it.
    if (costmap.clearance(pose) < std::min(options().stop_clearance, here - 0.01)) {
      return driven;
    }
    driven += distance;
  }
  return HUGE_VAL;
}

bool PathFollower::pathBlocked(const PathPosition & position, double speed, const Costmap & costmap) const
{
  const double until = position.s + kReplanDistance + options().limits.brakingDistance(speed);
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
  const double left = handling_.leftInBend(speed, last_bend_);
  const double greatest = std::max(options().limits.acc_lim_x, options().limits.dec_lim_x);
  const double slack = std::max(kSpeedSlack, kSlackPart * lags().speed * greatest);
  const double from = std::clamp(last_.speed, speed - slack, speed + slack);
  const bool slower = std::abs(wanted) < std::abs(from) || wanted * from < 0.0;
  const double braking =
    std::min(options().limits.dec_lim_x, kBrakingReserve * (brake ? left : 1.0) * options().limits.deceleration(from));
  const double step = (slower ? braking : left * options().limits.acc_lim_x) * period;
  return from + std::clamp(wanted - from, -step, step);
}
}  // namespace f1tenth_racer
