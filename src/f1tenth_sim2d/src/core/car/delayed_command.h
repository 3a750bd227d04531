#pragma once

#include <deque>

#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// Commands on their way from the driver to the actuators: each takes effect after the car's latency.
template <typename Command>
class DelayedCommand
{
public:
  explicit DelayedCommand(const VehicleParameters & parameters)
  : latency_(fromSeconds(parameters.actuation_latency)), timeout_(fromSeconds(parameters.command_timeout))
  {
  }

  void give(const Command & command, SimTime now) { pending_.push_back({now, command}); }

  /// Puts commands into effect that are due at now.
  void takeEffect(SimTime now)
  {
    while (!pending_.empty() && pending_.front().issued + latency_ <= now) {
      active_ = pending_.front();
      pending_.pop_front();
    }
  }

  /// The command in effect; a default one before the first.
  const Command & active() const { return active_.command; }
  /// Whether the command has been in effect for longer than the car's timeout.
  bool isOld(SimTime now) const { return now - active_.issued > latency_ + timeout_; }

private:
  struct Given
  {
    SimTime issued{0};
    Command command{};
  };

  SimTime latency_;
  SimTime timeout_;
  std::deque<Given> pending_;
  Given active_;
};
}  // namespace f1tenth_sim2d
