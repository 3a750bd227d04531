#pragma once

#include <vector>

#include <move_base/map/costmap.h>
#include "path/terms.h"
#include "seen/obstacle_tracker.h"

namespace f1tenth_racer
{
/// Where something that drives about is going to be, if it keeps its speed and its distance from the walls of the road.
class Forecast
{
public:
  /// @param now  s, from when on
  Forecast(const MovingObstacle & obstacle, const Costmap & costmap, double now);

  /// The same, if it brakes from now on.
  /// @param deceleration  m/s^2
  Forecast braking(double deceleration) const;

  /// The same, if it may at any time be as far to either side as it has strayed to one.
  Forecast anywhere() const;

  /// Whether it strays so far from where it was expected that nobody can tell on which side it will be.
  bool strays() const;

  /// m/s, now
  double speed() const { return speed_; }
  /// m/s, in the end
  double lastSpeed() const { return deceleration_ > 0.0 ? 0.0 : speed_; }
  /// How far it still drives after some time, s, until it stands, m; 0 if it does not brake.
  double wayToStand(double time) const;
  /// Its outline after some time, s; the last one known, when that is too long. It widens with time by as much as the
  /// same forecasts would have been wrong in the past: a car that weaves may be wherever it weaves to.
  Box at(double time) const;

private:
  std::vector<Box> outlines_;
  double speed_;
  Interval unrest_;          // beside what is forecast
  bool is_anywhere_{false};  // from now on, not only after some time
  double deceleration_{0.0};
};

/// How far forecasts reach, s.
constexpr double kForecastTime = 4.0;
}  // namespace f1tenth_racer
