#pragma once

#include <optional>

#include "control/dead_reckoning.h"
#include "control/handling.h"
#include "control/response_lag.h"
#include "control/slip_watch.h"
#include "control/traction_watch.h"

namespace move_base
{
/// What is known of a car's motion.
struct Sighting
{
  CarState car;
  double seen{0.0};      ///< s, when it was at its pose
  double measured{0.0};  ///< s, when it had its speed
};

/// Where a car is now, and how it responds to its commands.
class CarWatch
{
public:
  /// @param told  how it is said to respond
  explicit CarWatch(const FollowerOptions & told);

  /// @param now  s, not before the commands already noted
  /// @return the car's motion now
  CarState note(const Sighting & sighting, double now);
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
  void noteBend(const Sighting & sighting);

  double told_latency_;  // s
  double told_slip_;     // rad per m/s^2
  DeadReckoning reckoning_;
  ResponseLag speed_lag_;
  ResponseLag yaw_lag_;
  std::optional<Sighting> before_;
  SlipWatch slip_watch_;
  TractionWatch traction_watch_;
};
}  // namespace move_base
