#pragma once

#include "car/car_state.h"
#include "path/speed_profile.h"

namespace move_base
{
struct FollowerOptions
{
  SpeedLimits limits;
  double latency{0.05};            ///< s, from measuring a pose to the wheels acting on the command
  double tracking_distance{0.45};  ///< m, in which an error of the path is driven out when standing
  double tracking_time{0.12};      ///< s, added to it per m/s
  double slip_gradient{0.0};       ///< rad per m/s^2 of lateral acceleration, that the rear axle drifts outwards
  double load_transfer{0.0};       ///< per m/s^2, part of its load that the rear axle gains and the front one loses
  double yaw_lag{0.0};             ///< s per m/s, by which the yaw follows the wheels
  double stop_clearance{0.0};      ///< m, with less on its predicted way the car stops before
  double replan_distance{2.5};     ///< m beyond the braking distance, an obstacle on the path there is reported
  double max_path_deviation{0.5};  ///< m, farther from its path the car has lost it

  /// @throws OptionError
  void validate() const;
};

/// How late a car does what it is told.
struct Lags
{
  double latency{0.0};  ///< s, from measuring a pose to the wheels acting on the command
  double speed{0.0};    ///< s, that its speed lags behind its command
};

/// What is known of a car's tyres beside what the options say.
struct Tyres
{
  double slip{1.0};      ///< times what the options say
  double traction{1.0};  ///< share of the acceleration told that comes of it, where the car falls behind its command
  bool felt{true};       ///< whether a bend has shown how far they slip
};

struct DriveCommand
{
  double speed{0.0};      ///< m/s, negative backwards
  double curvature{0.0};  ///< 1/m, positive is steering to the left

  double yawRate() const { return speed * curvature; }
  /// rad, of the wheels; straight for a car that stops.
  double steeringAngle(const SpeedLimits & limits) const { return speed == 0.0 ? 0.0 : limits.wheelAngle(curvature); }
};

/// How the car answers, and what may be asked of it with the tyres that it is found to have.
class Handling
{
public:
  static constexpr double kSpeedLag = 0.055;  ///< s, that a car's speed lags behind its command besides the latency

  /// @throws OptionError
  explicit Handling(const FollowerOptions & options);

  /// Those given, with what the tyres allow.
  const FollowerOptions & options() const { return options_; }
  /// Those of the options until others are set.
  const Lags & lags() const { return lags_; }
  /// Where the tyres clearly slip more than the options say, or pass on but a share of the acceleration told, they have less
  /// grip, and the car is asked for less; to the side also until a bend has shown it, and where it answers late.
  /// @return whether that changes the options
  bool set(const Lags & lags, const Tyres & tyres);

  /// Of a curvature, 1/m, what wheels and tyres allow.
  double drivable(double curvature, double speed) const;
  /// m/s, at which the tyres hold the car on a curvature, 1/m: one that has left its path in a bend comes back only if it
  /// slows down.
  double speedFor(double curvature) const;
  /// rad, that the rear axle drifts outwards.
  double slipOn(double curvature, double speed) const;
  /// Part of an acceleration that the tyres have left that hold a car in a bend, 1/m: braking with more than that, its tail
  /// comes round, and speeding up with more, its front axle loses the load that it steers with.
  double leftInBend(double speed, double bend) const;
  /// m/s, that a car is not told to be slower than, whatever it brakes for in a bend: who spins does not stop sooner. It is
  /// in a bend for as long as it turns, whatever its wheels are told.
  /// @param bend  1/m, of its way, that it was told last
  double gentlest(const CarState & car, double bend) const;
  /// 1/m, to command for a way so bent, while a car is told to change its speed. Understeer is that of the bend which the
  /// tyres bear: a car that brakes oversteers, and at its critical speed that of a bend still to come would take all of
  /// the wheels' angle away before there is any force. The yaw follows the wheels alike at all loads then: a single track,
  /// L r / v = delta - (front - rear) a_y - L (front + rear) dr/dt, slips of the axles in rad per m/s^2.
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
}  // namespace move_base
