#pragma once

#include <cmath>
#include <vector>

#include <move_base/map/costmap.h>
#include <move_base/path/path.h>

#include "options/option.h"
#include "path/terms.h"

namespace f1tenth_racer
{
/// What each means is told by visitEach().
struct SpeedLimits
{
  double max_vel_x{0.4};
  double max_vel_x_backwards{0.2};
  double min_vel_x{0.15};
  double max_vel_theta{0.3};
  double acc_lim_x{0.5};
  double dec_lim_x{0.5};
  double braking_power{1000.0};
  double max_lateral_acceleration{3.0};
  double unknown_lateral_part{0.7};
  double max_steering_angle{0.4189};
  double max_steering_rate{2.5};
  double understeer_gradient{0.0};
  double wheelbase{0.3302};
  double full_speed_clearance{0.35};
  double slowest_clearance{0.05};
  double unknown_full_speed_clearance{0.5};

  template <class Self, class Visit>
  static void visitEach(Self & self, const Visit & visit)
  {
    visit({"max_vel_x", "m/s", "greatest speed", Option::Range::kPositive}, self.max_vel_x);
    visit(
      {"max_vel_x_backwards", "m/s", "greatest speed backwards", Option::Range::kPositive}, self.max_vel_x_backwards);
    visit(
      {"min_vel_x", "m/s", "least speed beside obstacles and when creeping to the end of a path, at most max_vel_x",
       Option::Range::kPositive},
      self.min_vel_x);
    visit({"max_vel_theta", "rad/s", "greatest rate of turn", Option::Range::kPositive}, self.max_vel_theta);
    visit({"acc_lim_x", "m/s^2", "speeding up", Option::Range::kPositive}, self.acc_lim_x);
    visit(
      {"dec_lim_x", "m/s^2", "slowing down; as a parameter acc_lim_x unless set; harder for an obstacle that appears",
       Option::Range::kPositive},
      self.dec_lim_x);
    visit(
      {"braking_power", "m^2/s^3", "speed times deceleration: braked harder, the tail comes round",
       Option::Range::kPositive},
      self.braking_power);
    visit({"max_lateral_acceleration", "m/s^2", "in bends", Option::Range::kPositive}, self.max_lateral_acceleration);
    visit(
      {"unknown_lateral_part", "", "of max_lateral_acceleration, in bends near what is not on the map",
       Option::Range::kPart},
      self.unknown_lateral_part);
    visit({"max_steering_angle", "rad", "of the wheels", Option::Range::kSteering}, self.max_steering_angle);
    visit({"max_steering_rate", "rad/s", "of the wheels", Option::Range::kPositive}, self.max_steering_rate);
    visit(
      {"understeer_gradient", "rad per m/s^2", "by which the wheels must be turned further than without slip",
       Option::Range::kNotNegative},
      self.understeer_gradient);
    visit({"wheelbase", "m", "from axle to axle", Option::Range::kPositive}, self.wheelbase);
    visit(
      {"full_speed_clearance", "m", "with less beside the car it drives slower in proportion; above slowest_clearance",
       Option::Range::kPositive},
      self.full_speed_clearance);
    visit(
      {"slowest_clearance", "m", "with less it drives at min_vel_x", Option::Range::kNotNegative},
      self.slowest_clearance);
    visit(
      {"unknown_full_speed_clearance", "m", "full_speed_clearance near what is not on the map, if that is more",
       Option::Range::kNotNegative},
      self.unknown_full_speed_clearance);
  }

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
