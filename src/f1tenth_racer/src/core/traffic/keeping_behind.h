#pragma once

#include <cmath>
#include <vector>

#include "options/traffic_options.h"
#include "traffic/traffic.h"

namespace f1tenth_racer
{
/// The way that a car is about to drive.
struct OwnWay
{
  const Path & path;
  const std::vector<double> & speeds;  ///< m/s, along the path
  const SpeedLimits & limits;
  const Footprint & footprint;
  Departure departure;
  const TrafficOptions & traffic;
};

/// Whether another is going to be in the way, other than by driving into the car from behind.
bool isHindered(const OwnWay & way, const std::vector<Forecast> & others);

/// How fast a car may be behind another, m/s.
struct SpeedBehind
{
  double wanted{HUGE_VAL};  ///< so that it comes up to the other and goes on behind it
  double utmost{HUGE_VAL};  ///< so that it can just brake in time
};

/// @param speed         m/s, of the car now
/// @param deceleration  m/s^2, with which it brakes
SpeedBehind speedBehind(const Touch & touch, double speed, double deceleration, const TrafficOptions & traffic = {});

/// As fast as those ahead on the way allow, and slow enough to stop behind them if they brake.
SpeedBehind speedBehindOthers(const OwnWay & way, const std::vector<Forecast> & others);
}  // namespace f1tenth_racer
