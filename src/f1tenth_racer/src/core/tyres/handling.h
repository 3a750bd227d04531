#pragma once

#include <move_base/car.h>
#include "options/traffic_options.h"
#include "path/terms.h"
#include "speed/speed_profile.h"

namespace f1tenth_racer
{
/// What each means is told by visitEach().
struct FollowerOptions
{
  SpeedLimits limits;
  TrafficOptions traffic;
  double latency{0.05};
  double tracking_distance{0.45};
  double tracking_time{0.12};
  double slip_gradient{0.0};
  double unfelt_lateral_part{0.6};
  double load_transfer{0.0};
  double yaw_lag{0.0};
  double stop_clearance{0.0};

  template <class Self, class Visit>
  static void visitEach(Self & self, const Visit & visit)
  {
    SpeedLimits::visitEach(self.limits, visit);
    TrafficOptions::visitEach(self.traffic, visit);
    visit(
      {"latency", "s",
       "from measuring a pose to the wheels acting on the command, at least; up to 0.15 s more are measured",
       Option::Range::kNotNegative},
      self.latency);
    visit(
      {"tracking_distance", "m", "in which a path error is steered out from a standstill", Option::Range::kPositive},
      self.tracking_distance);
    visit({"tracking_time", "s", "added to it per m/s", Option::Range::kNotNegative}, self.tracking_time);
    visit(
      {"slip_gradient", "rad per m/s^2",
       "by which the nose points into a bend, until that has been measured; 0: it is not", Option::Range::kNotNegative},
      self.slip_gradient);
    visit(
      {"unfelt_lateral_part", "", "of max_lateral_acceleration, until a bend has shown how the tyres slip",
       Option::Range::kPart},
      self.unfelt_lateral_part);
    visit(
      {"load_transfer", "per m/s^2", "share of its load that the rear axle gains and the front one loses",
       Option::Range::kNotNegative},
      self.load_transfer);
    visit({"yaw_lag", "s per m/s", "by which the yaw follows the wheels", Option::Range::kNotNegative}, self.yaw_lag);
    visit(
      {"stop_clearance", "m", "the car stops before it has less on its predicted way", Option::Range::kNotNegative},
      self.stop_clearance);
  }

  /// @throws OptionError
  void validate() const;
};

/// How late a car responds to commands.
struct Lags
{
  double latency{0.0};  ///< s, from measuring a pose to the wheels acting on the command
  double speed{0.0};    ///< s, by which its speed lags behind its command
};

/// What is known of a car's tyres beyond what the options say.
struct Tyres
{
  double slip{1.0};      ///< times what the options say
  double traction{1.0};  ///< share of the commanded acceleration that is reached, where the car falls behind
  bool felt{true};       ///< whether a bend has shown how far they slip
};

/// How the car responds, and what may be asked of it with the tyres that it is found to have.
class Handling
{
public:
  static constexpr double kSpeedLag = 0.055;  ///< s, by which a car's speed lags its command, besides the latency

  /// @throws OptionError
  explicit Handling(const FollowerOptions & options);

  /// The options given, with what the tyres allow.
  const FollowerOptions & options() const { return options_; }
  /// From the options and kSpeedLag until others are set.
  const Lags & lags() const { return lags_; }
  /// Where the tyres clearly slip more than the options say, or pass on only a share of the commanded acceleration,
  /// they have less grip, and less is asked of the car; to the side also until a bend has shown the grip, and where the
  /// car responds late.
  /// @return whether that changes the options
  bool set(const Lags & lags, const Tyres & tyres);

  /// The part of a curvature, 1/m, that wheels and tyres allow.
  double drivable(double curvature, double speed) const;
  /// m/s, at which the tyres hold the car on a curvature, 1/m: one that has left its path in a bend comes back only if
  /// it slows down.
  double speedFor(double curvature) const;
  /// rad, by which the rear axle drifts outwards.
  double slipOn(double curvature, double speed) const;
  /// Share of an acceleration that is left to tyres that hold a car in a bend, 1/m: if it brakes harder, its tail comes
  /// round, and if it speeds up harder, its front axle loses the load that it steers with.
  double leftInBend(double speed, double bend) const;
  /// m/s, the least speed that is commanded in a bend, whatever the car brakes for: a car that spins does not stop
  /// sooner. It is in a bend for as long as it turns, whatever the command to its wheels.
  /// @param bend  1/m, of its way, as commanded last
  double gentlest(const CarState & car, double bend) const;
  /// 1/m, to command for a way of this curvature while a car is to change its speed. Understeer is that of the bend
  /// which the tyres bear: a car that brakes oversteers, and at its critical speed that of a bend still to come would
  /// take all of the wheels' angle away before there is any force. The yaw then follows the wheels alike at all loads:
  /// a single track, L r / v = delta - (front - rear) a_y - L (front + rear) dr/dt, axle slips in rad per m/s^2.
  /// @param curvature  1/m, of the way
  /// @param borne  1/m, of the way where the command takes effect
  double withUndersteer(double curvature, double borne, double speed, double commanded) const;

private:
  double reserveForLatency() const;
  double lateralOn(double curvature, double speed) const;
  double accelerationTo(double commanded, double speed) const;

  FollowerOptions given_;
  FollowerOptions options_;  // as the car is found to be
  Lags lags_;
  Tyres tyres_;
  double reserve_{0.0};  // part of the lateral acceleration
  double grip_to_side_;  // m/s^2: more than is planned with until the tyres have been felt
};
}  // namespace f1tenth_racer
