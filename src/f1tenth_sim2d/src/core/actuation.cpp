#include "actuation.h"

#include <algorithm>
#include <cmath>

#include "sim_time.h"
#include "trigonometry.h"

namespace f1tenth_sim2d
{
namespace
{
// m/s; below it a car that is told to stop stands. Proportional control alone would creep for ever.
constexpr double kStandstill = 0.005;
}  // namespace

DriveCommand commandFromTwist(double linear_x, double angular_z, double wheelbase)
{
  if (angular_z == 0.0) {
    return {linear_x, 0.0};
  }
  const double ahead = linear_x < 0.0 ? -1.0 : 1.0;
  return {linear_x, direction(ahead * wheelbase * angular_z, std::abs(linear_x))};
}

double limitedAcceleration(double v, double acceleration, const VehicleParameters & p)
{
  if ((v <= p.v_min && acceleration <= 0.0) || (v >= p.v_max && acceleration >= 0.0)) {
    return 0.0;
  }
  const double forward_max = v > p.v_switch ? p.a_max * p.v_switch / v : p.a_max;
  return std::clamp(acceleration, -p.a_max, forward_max);
}

Actuation::Actuation(const VehicleParameters & parameters)
: parameters_(parameters),
  latency_(fromSeconds(parameters.actuation_latency)),
  timeout_(fromSeconds(parameters.command_timeout))
{
}

void Actuation::command(const DriveCommand & command, SimTime now)
{
  const VehicleParameters & p = parameters_;
  pending_.push_back(
    {now,
     {std::clamp(command.speed, p.v_min, p.v_max),
      std::clamp(command.steering_angle, -p.steering_max, p.steering_max)}});
}

SingleTrackInput Actuation::input(const SingleTrackState & state, SimTime now, double dt)
{
  takeEffect(now);
  const double rate = (active_.steering_angle - state.delta) / dt;
  return {std::clamp(rate, -parameters_.steering_rate_max, parameters_.steering_rate_max), speedControl(state, dt)};
}

void Actuation::takeEffect(SimTime now)
{
  while (!pending_.empty() && pending_.front().issued + latency_ <= now) {
    active_ = pending_.front().command;
    active_issued_ = pending_.front().issued;
    pending_.pop_front();
  }
  if (now - active_issued_ > timeout_) {
    active_.speed = 0.0;
  }
}

double Actuation::speedControl(const SingleTrackState & state, double dt) const
{
  const double speed = bodyVelocity(state).x;
  const bool stands = active_.speed == 0.0 && std::abs(speed) < kStandstill;
  const double gain = stands ? 1.0 / dt : parameters_.speed_gain;
  return limitedAcceleration(speed, gain * (active_.speed - speed), parameters_);
}
}  // namespace f1tenth_sim2d
