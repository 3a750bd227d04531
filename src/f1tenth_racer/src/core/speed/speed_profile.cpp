#include "speed/speed_profile.h"

#include <workspace_support/maths/exponential.h>
#include <workspace_support/option_checks.h>

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
// Steering is taken over this many points to either side: a change within less is the path's discretisation.
constexpr std::size_t kSteeringReach = 2;
constexpr double kSteeringReserve = 0.025;  // rad, of the wheels, to steer back with
constexpr double kLeastLateral = 0.2;       // of the lateral acceleration, where the wheels have no angle left
// Near what is not on the map.
constexpr double kUnknownReach = 2.5;  // m

double cube(double x)
{
  return x * x * x;
}

// The speed at which the tyres hold the car in a bend, and the bend leaves the wheels the angle that understeer takes.
double speedForBend(double curvature, const SpeedLimits & limits)
{
  if (limits.understeer_gradient == 0.0) {
    return limits.speedInBend(curvature);
  }
  const double left = limits.max_steering_angle - kSteeringReserve - limits.wheelAngle(curvature);
  const double most = limits.max_lateral_acceleration;
  return std::sqrt(std::clamp(left / limits.understeer_gradient, kLeastLateral * most, most) / curvature);
}

double speedForCurvature(const PathPoint & point, const SpeedLimits & limits)
{
  const double cruise = point.reverse ? limits.max_vel_x_backwards : limits.max_vel_x;
  const double bend = std::abs(point.curvature);
  if (bend == 0.0) {
    return cruise;
  }
  return std::min({cruise, speedForBend(bend, limits), limits.max_vel_theta / bend});
}

double speedForSteering(const Path & path, const PathStretch & stretch, std::size_t i, const SpeedLimits & limits)
{
  const PathPoint & before = path[std::max(stretch.begin + kSteeringReach, i) - kSteeringReach];
  const PathPoint & after = path[std::min(stretch.end - 1, i + kSteeringReach)];
  const double turn = std::abs(limits.wheelAngle(after.curvature) - limits.wheelAngle(before.curvature));
  return turn > 0.0 ? limits.max_steering_rate * (after.s - before.s) / turn : HUGE_VAL;
}

double speedForClearance(const Pose2 & pose, const Costmap & costmap, const SpeedLimits & limits)
{
  const double room = limits.full_speed_clearance - limits.slowest_clearance;
  const double part = std::clamp((costmap.clearance(pose) - limits.slowest_clearance) / room, 0.0, 1.0);
  return limits.min_vel_x + part * (limits.max_vel_x - limits.min_vel_x);
}

void limitByAcceleration(const Path & path, const PathStretch & stretch, const SpeedLimits & limits, double * speeds)
{
  speeds[stretch.end - 1] = 0.0;
  for (std::size_t i = stretch.end - 1; i-- > stretch.begin;) {
    const double step = path[i + 1].s - path[i].s;
    const double deceleration =
      limits.deceleration(speeds[i + 1]) * limits.leftInBend(speeds[i + 1], path[i + 1].curvature);
    speeds[i] = std::min(speeds[i], std::sqrt(speeds[i + 1] * speeds[i + 1] + 2.0 * deceleration * step));
  }
  for (std::size_t i = stretch.begin; i + 1 < stretch.end; ++i) {
    const double step = path[i + 1].s - path[i].s;
    const double acceleration = limits.acc_lim_x * limits.leftInBend(speeds[i], path[i].curvature);
    speeds[i + 1] = std::min(speeds[i + 1], std::sqrt(speeds[i] * speeds[i] + 2.0 * acceleration * step));
  }
}

// Near what is not on the map, errors cost most.
SpeedLimits besideUnknown(const SpeedLimits & given, const Caution & caution)
{
  SpeedLimits careful = given;
  careful.max_lateral_acceleration *= std::min(caution.lateral_part, given.unknown_lateral_part);
  careful.full_speed_clearance = std::max(given.full_speed_clearance, given.unknown_full_speed_clearance);
  return careful;
}
}  // namespace

void SpeedLimits::validate() const
{
  checkEach(*this);
  requireOption(
    full_speed_clearance > slowest_clearance, "full_speed_clearance", full_speed_clearance, "above slowest_clearance");
  requireOption(min_vel_x <= max_vel_x, "min_vel_x", min_vel_x, "above 0 and at most max_vel_x");
}

double SpeedLimits::deceleration(double speed) const
{
  return std::min(dec_lim_x, braking_power / std::max(std::abs(speed), 1e-3));
}

// With a limited power, speed^2 / power is the slope of the distance over the speed.
double SpeedLimits::brakingDistance(double speed) const
{
  const double full = std::min(std::abs(speed), braking_power / dec_lim_x);
  return (cube(std::abs(speed)) - cube(full)) / (3.0 * braking_power) + full * full / (2.0 * dec_lim_x);
}

double SpeedLimits::speedInBend(double curvature) const
{
  return curvature == 0.0 ? HUGE_VAL : std::sqrt(max_lateral_acceleration / std::abs(curvature));
}

double SpeedLimits::leftInBend(double speed, double curvature) const
{
  const double lateral = speed * speed * std::abs(curvature) / max_lateral_acceleration;
  return std::sqrt(std::max(0.0, 1.0 - lateral * lateral));
}

double SpeedLimits::speedToStopWithin(double distance) const
{
  const double full = braking_power / dec_lim_x;
  const double rest = distance - brakingDistance(full);
  return rest > 0.0 ? maths::cbrt(cube(full) + 3.0 * braking_power * rest)
                    : std::sqrt(2.0 * dec_lim_x * std::max(distance, 0.0));
}

std::vector<double> speedProfile(
  const Path & path, const Costmap & costmap, const SpeedLimits & given, const Caution & caution)
{
  SpeedLimits limits = given;
  limits.max_lateral_acceleration *= caution.lateral_part;
  const SpeedLimits careful = besideUnknown(given, caution);
  std::vector<double> speeds(path.size());
  for (const PathStretch & stretch : stretches(path)) {
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) {
      const SpeedLimits & here = costmap.seesUnknown(path[i].pose.position(), kUnknownReach) ? careful : limits;
      speeds[i] = std::min(
        {speedForCurvature(path[i], here), speedForSteering(path, stretch, i, here),
         speedForClearance(path[i].pose, costmap, here), path[i].s < caution.until ? caution.pace : HUGE_VAL});
    }
    limitByAcceleration(path, stretch, limits, speeds.data());
  }
  return speeds;
}
}  // namespace f1tenth_racer
