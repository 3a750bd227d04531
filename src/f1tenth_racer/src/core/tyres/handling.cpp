#include "tyres/handling.h"

#include <workspace_support/maths/exponential.h>
#include <workspace_support/option_checks.h>

#include <algorithm>

namespace f1tenth_racer
{
namespace
{
constexpr double kSlipStep = 0.03;      // share by which the slip must change to be taken into account
constexpr double kUsualSlip = 1.15;     // times that of the options, up to which the grip is that of a dry road
constexpr double kSlipPower = 1.5;      // of the slip beyond: on average it is measured before it has built up
constexpr double kUsualTraction = 0.9;  // of the commanded acceleration, from which the grip is that of a dry road
constexpr double kSpinning = 0.85;      // of what spinning wheels pass on, while they steer as well
constexpr double kUsualDelay = 0.08;    // s of latency beyond that of the options, that need no reserve
constexpr double kLateReserve = 4.0;    // 1/s, share of the lateral acceleration for each second of latency beyond
constexpr double kReserveStep = 0.01;   // by which that must change to be taken into account
constexpr double kBends = 0.25;         // of the lateral acceleration, from which braking is limited for it
constexpr double kLeastLeft = 0.35;     // of the acceleration, however hard the car corners
}  // namespace

void FollowerOptions::validate() const
{
  limits.validate();
  checkEach(*this);
  const double utmost = 1.0 / std::max(limits.acc_lim_x, limits.dec_lim_x);
  requireOption(
    load_transfer < utmost, "load_transfer", load_transfer,
    "at least 0 and below 1 / (greater of acc_lim_x and dec_lim_x) = " + std::to_string(utmost));
}

Handling::Handling(const FollowerOptions & options)
: given_(options),
  options_(options),
  lags_{options.latency, kSpeedLag + options.latency},
  grip_to_side_(options.limits.max_lateral_acceleration)
{
  options_.validate();
}

// An error that is corrected late has grown by then.
double Handling::reserveForLatency() const
{
  return kLateReserve * std::max(0.0, lags_.latency - given_.latency - kUsualDelay);
}

bool Handling::set(const Lags & lags, const Tyres & tyres)
{
  lags_ = lags;
  const double reserve = reserveForLatency();
  const bool same_slip = std::abs(tyres.slip - tyres_.slip) < kSlipStep * tyres_.slip;
  const bool same_traction = std::abs(tyres.traction - tyres_.traction) < kSlipStep * tyres_.traction;
  const bool same_reserve = std::abs(reserve - reserve_) < kReserveStep;
  if (same_slip && same_traction && same_reserve && tyres.felt == tyres_.felt) {
    return false;
  }
  tyres_ = tyres;
  reserve_ = reserve;
  options_.slip_gradient = given_.slip_gradient * tyres.slip;
  options_.limits.understeer_gradient = given_.limits.understeer_gradient * tyres.slip;
  options_.yaw_lag = given_.yaw_lag * tyres.slip;
  const double passed_on = tyres.traction < kUsualTraction ? kSpinning * tyres.traction : 1.0;
  const double grip = std::min(passed_on, maths::pow(kUsualSlip / tyres.slip, kSlipPower));
  options_.limits.acc_lim_x = given_.limits.acc_lim_x * grip;
  options_.limits.dec_lim_x = given_.limits.dec_lim_x * grip;
  options_.limits.braking_power = given_.limits.braking_power * grip;
  grip_to_side_ = given_.limits.max_lateral_acceleration * grip;
  const double most = (1.0 - reserve) * grip_to_side_;
  options_.limits.max_lateral_acceleration =
    tyres.felt ? most : std::min(most, given_.unfelt_lateral_part * given_.limits.max_lateral_acceleration);
  return true;
}

double Handling::drivable(double curvature, double speed) const
{
  const double limit = std::min(options_.limits.maxCurvature(), grip_to_side_ / std::max(speed * speed, 1e-6));
  return std::clamp(curvature, -limit, limit);
}

double Handling::speedFor(double curvature) const
{
  const double bend = std::min(std::abs(curvature), options_.limits.maxCurvature());
  return std::max(options_.limits.speedInBend(bend), options_.limits.min_vel_x);
}

// m/s^2, that the tyres can provide.
double Handling::lateralOn(double curvature, double speed) const
{
  return std::clamp(speed * speed * curvature, -grip_to_side_, grip_to_side_);
}

double Handling::slipOn(double curvature, double speed) const
{
  return options_.slip_gradient * lateralOn(curvature, speed);
}

double Handling::leftInBend(double speed, double bend) const
{
  return std::max(options_.limits.leftInBend(speed, bend), kLeastLeft);
}

double Handling::gentlest(const CarState & car, double bend) const
{
  const double speed = std::abs(car.speed);
  const double turns = std::abs(car.yaw_rate) / std::max(speed, kStandingSpeed);
  const double bent = std::max(std::abs(bend), turns);
  if (speed * speed * bent <= kBends * options_.limits.max_lateral_acceleration) {
    return 0.0;
  }
  return speed - leftInBend(speed, bent) * options_.limits.deceleration(speed) * lags_.speed;
}

// By how much the car speeds up, its speed lagging behind the command.
double Handling::accelerationTo(double commanded, double speed) const
{
  const double gain = (std::abs(commanded) - std::abs(speed)) / lags_.speed;
  return std::clamp(gain, -options_.limits.deceleration(speed), options_.limits.acc_lim_x);
}

// An axle's slip grows with its lateral force over its load.
double Handling::withUndersteer(double curvature, double borne, double speed, double commanded) const
{
  const double lateral = lateralOn(borne, speed);
  const double shift = options_.load_transfer * accelerationTo(commanded, speed);
  const double front = (options_.slip_gradient + options_.limits.understeer_gradient) / (1.0 - shift);
  const double rear = options_.slip_gradient / (1.0 + shift);
  const double farthest = options_.limits.max_steering_angle;
  const double angle = options_.limits.wheelAngle(curvature) + (front - rear) * lateral;
  return maths::tan(std::clamp(angle, -farthest, farthest)) / options_.limits.wheelbase;
}
}  // namespace f1tenth_racer
