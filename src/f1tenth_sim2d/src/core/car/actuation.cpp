#include "core/car/actuation.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
// m/s; below it a car that is commanded to stop stands still. Proportional control alone would creep for ever.
constexpr double kStandstill = 0.005;
}  // namespace

DriveCommand commandFromTwist(double linear_x, double angular_z, double wheelbase)
{
  if (angular_z == 0.0) {
    return {linear_x, 0.0};
  }
  const double ahead = linear_x < 0.0 ? -1.0 : 1.0;
  return {linear_x, maths::atan2(ahead * wheelbase * angular_z, std::abs(linear_x))};
}

double limitedAcceleration(double v, double acceleration, const VehicleParameters & p)
{
  if ((v <= p.v_min && acceleration <= 0.0) || (v >= p.v_max && acceleration >= 0.0)) {
    return 0.0;
  }
  const double forward_max = v > p.v_switch ? p.a_max * p.v_switch / v : p.a_max;
  return std::clamp(acceleration, -p.a_max, forward_max);
}

Actuation::Actuation(const VehicleParameters & parameters) : parameters_(parameters), commands_(parameters) {}

void Actuation::command(const DriveCommand & command, SimTime now)
{
  const VehicleParameters & p = parameters_;
  commands_.give(
    {std::clamp(command.speed, p.v_min, p.v_max), std::clamp(command.steering_angle, -p.steering_max, p.steering_max)},
    now);
}

SteeredInput Actuation::input(double speed, double steering_angle, SimTime now, double dt)
{
  commands_.takeEffect(now);
  const DriveCommand & wanted = commands_.active();
  const double rate = (wanted.steering_angle - steering_angle) / dt;
  const double wanted_speed = commands_.isOld(now) ? 0.0 : wanted.speed;
  return {
    std::clamp(rate, -parameters_.steering_rate_max, parameters_.steering_rate_max),
    speedControl(wanted_speed, speed, dt)};
}

double Actuation::speedControl(double wanted, double speed, double dt) const
{
  const bool stands = wanted == 0.0 && std::abs(speed) < kStandstill;
  const double gain = stands ? 1.0 / dt : parameters_.speed_gain;
  return limitedAcceleration(speed, gain * (wanted - speed), parameters_);
}
}  // namespace f1tenth_sim2d
