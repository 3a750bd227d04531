#pragma once

#include <vector>

#include "map/costmap.h"
#include "seen/obstacle_tracker.h"

namespace move_base
{
/// Where something that drives about is going to be, if it keeps its speed and its distance from the walls of the road.
class Forecast
{
public:
  /// @param now  s, from when on
  Forecast(const MovingObstacle & obstacle, const Costmap & costmap, double now);

  double speed() const { return speed_; }
  /// Its outline after some time, s; the last one known, when that is too long.
  Box at(double time) const;

private:
  std::vector<Box> outlines_;
  double speed_;
};

/// Of everything that moves on the costmap.
std::vector<Forecast> forecasts(const Costmap & costmap, double now);

/// How far forecasts reach, s.
constexpr double kForecastTime = 4.0;
}  // namespace move_base
