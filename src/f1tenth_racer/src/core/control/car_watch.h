#pragma once

#include <optional>

#include "control/dead_reckoning.h"
#include "tyres/handling.h"
#include "tyres/response_lag.h"
#include "tyres/slip_watch.h"
#include "tyres/traction_watch.h"

namespace f1tenth_racer
{
/// Where a car is now, and how it responds to its commands.
class CarWatch
{
public:
  /// @param told  how it is said to respond
  explicit CarWatch(const FollowerOptions & told);

  /// @param now  s, not before the commands already noted
  /// @return the car's motion now
  CarState note(const CarSighting & sighting, double now);
  /// Notes a command to the car, time in s.
  /// @param bend  1/m, the curvature of its path that is to result
  void noteCommand(double time, const DriveCommand & command, double bend);
  /// To be called when time jumps back.
  void clear();

  /// How late it responds to commands.
  Lags lags() const;
  /// What its tyres have shown.
  Tyres tyres() const;

private:
  void noteBend(const CarSighting & sighting);

  double told_latency_;  // s
  double told_slip_;     // rad per m/s^2
  DeadReckoning reckoning_;
  ResponseLag speed_lag_;
  ResponseLag yaw_lag_;
  std::optional<CarSighting> before_;
  SlipWatch slip_watch_;
  TractionWatch traction_watch_;
};
}  // namespace f1tenth_racer
