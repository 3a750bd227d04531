#pragma once

#include <optional>
#include <vector>

#include <move_base/path/path.h>
#include "path/terms.h"
#include "speed/speed_profile.h"
#include "traffic/forecast.h"

namespace f1tenth_racer
{
/// Where a car is on its path at some time.
struct Moment
{
  double time{0.0};      ///< s from now
  double s{0.0};         ///< m along the path
  std::size_t index{0};  ///< of the point before
  Pose2 pose;
};

/// Where the car starts.
struct Departure
{
  double s{0.0};        ///< m along the path
  double lateral{0.0};  ///< m, beside it to the left; is steered out
  double speed{0.0};    ///< m/s
};

/// A drive forwards along a path as fast as its profile and the car allow, until its end or the horizon, s.
std::vector<Moment> driveAlong(
  const Path & path, const std::vector<double> & speeds, const Departure & departure, const SpeedLimits & limits,
  double horizon);

/// Where an outline is as seen from a pose, m: along it and to its left.
struct Extent
{
  Interval along;
  Interval beside;
};
Extent extentOf(const Box & outline, const Pose2 & from);

/// Whether a car already reaches beyond the rear of another, and not yet beyond its front.
bool isBeside(const Box & other, const Pose2 & car, const Footprint & footprint);

/// What a car may rely on of another: one that strays may be anywhere until the car is beside it.
Forecast seenFrom(const Pose2 & car, const Footprint & footprint, const Forecast & other);

/// Forecasts of everything that moves, as seen from a car.
std::vector<Forecast> forecasts(
  const std::vector<MovingObstacle> & moving, const Costmap & costmap, double now, const Pose2 & car);

/// When a car would touch another.
struct Touch
{
  double time{0.0};   ///< s from now
  double way{0.0};    ///< m driven until then
  double speed{0.0};  ///< m/s, of the other along the way
  bool ahead{false};  ///< whether its middle is beyond that of the car then, or all of it is now: the car may fall back
  bool behind{false};  ///< whether it does not even reach beyond the rear end: it drives into the car
};

/// The first time at which the car comes nearer to the other than margin, m, and nearer than it is now.
std::optional<Touch> firstTouch(
  const std::vector<Moment> & drive, const Footprint & footprint, const Forecast & other, double margin);
}  // namespace f1tenth_racer
