#pragma once

#include <cmath>
#include <vector>

#include <move_base/map/costmap.h>
#include <move_base/path/path.h>

#include "path/terms.h"

namespace f1tenth_racer
{
struct SpeedLimits
{
  double max_vel_x{0.4};                 ///< m/s
  double max_vel_x_backwards{0.2};       ///< m/s
  double max_vel_theta{0.3};             ///< rad/s
  double acc_lim_x{0.5};                 ///< m/s^2, speeding up
  double dec_lim_x{0.5};                 ///< m/s^2, slowing down
  double braking_power{1000.0};          ///< m^2/s^3, speed times deceleration: braked harder, the tail comes round
  double max_lateral_acceleration{3.0};  ///< m/s^2
  double max_steering_angle{0.4189};     ///< rad
  double max_steering_rate{2.5};         ///< rad/s
  double understeer_gradient{0.0};    ///< rad per m/s^2, by which the wheels must be turned further than without slip
  double wheelbase{0.3302};           ///< m
  double full_speed_clearance{0.35};  ///< m, with less beside the car it drives slower in proportion
  double slowest_clearance{0.05};     ///< m, with less it drives at the least speed
  double min_vel_x{0.15};             ///< m/s, least speed beside obstacles and when creeping to the end of a path

  /// @throws OptionError
  void validate() const;

  /// The deceleration with which the car may slow down at a speed, m/s^2.
  double deceleration(double speed) const;
  /// The distance in which it stops from a speed, m.
  double brakingDistance(double speed) const;
  /// rad, of the wheels on a curvature, 1/m.
  double wheelAngle(double curvature) const { return maths::atan(wheelbase * curvature); }
  /// 1/m, with the wheels turned as far as they go.
  double maxCurvature() const { return maths::tan(max_steering_angle) / wheelbase; }
  /// The speed, m/s, at which the tyres hold the car in a bend, 1/m; infinite for none.
  double speedInBend(double curvature) const;
  /// Share of an acceleration along the path that is left while the car drives a bend, 1/m: the friction ellipse.
  double leftInBend(double speed, double curvature) const;
  /// The speed from which it can stop within a distance, m/s.
  double speedToStopWithin(double distance) const;
};

/// How much slower than allowed a car drives along a path.
struct Caution
{
  double lateral_part{1.0};  ///< of the lateral acceleration, that it drives with
  double pace{HUGE_VAL};     ///< m/s, at most,
  double until{0.0};         ///< m along the path
};

/// The greatest speed at each point of a path, m/s, by curvature, steering rate and clearance, such that the car can
/// slow down in time for what lies ahead and stands where the driving direction changes and at the end. Near what the
/// lidar has seen that is not on the map, bends are driven more slowly, and narrow places as well.
std::vector<double> speedProfile(
  const Path & path, const Costmap & costmap, const SpeedLimits & limits, const Caution & caution = {});
}  // namespace f1tenth_racer
