#include "control/car_watch.h"

#include <algorithm>

namespace move_base
{
namespace
{
constexpr double kMostLatency = 0.15;  // s, beyond what it is told to be
constexpr double kLeastSlip = 0.2;     // times what it is told to be
constexpr double kMostSlip = 4.0;      // the same
}  // namespace

CarWatch::CarWatch(const FollowerOptions & told)
: told_latency_(told.latency),
  told_slip_(told.slip_gradient),
  speed_lag_(PathFollower::kSpeedLag + told.latency),
  slip_watch_(told.slip_gradient),
  traction_watch_(told.limits.acc_lim_x)
{
}

CarState CarWatch::note(const Sighting & sighting, double now)
{
  speed_lag_.noteSpeed(sighting.measured, sighting.car.speed);
  traction_watch_.noteSpeed(sighting.measured, sighting.car.speed);
  slip_watch_.note(sighting.seen, sighting.car.pose);
  return reckoning_.predict(sighting.car, sighting.seen, sighting.measured, now);
}

void CarWatch::noteCommand(double time, const DriveCommand & command)
{
  reckoning_.note(time, command);
  speed_lag_.noteCommand(time, command.speed);
  traction_watch_.noteCommand(command);
}

double CarWatch::latency() const
{
  return std::clamp(speed_lag_.lag() - PathFollower::kSpeedLag, told_latency_, told_latency_ + kMostLatency);
}

Tyres CarWatch::tyres() const
{
  if (told_slip_ <= 0.0) {
    return {};
  }
  const double slip = std::clamp(slip_watch_.gradient() / told_slip_, kLeastSlip, kMostSlip);
  return {slip, traction_watch_.share(), slip_watch_.hasFelt()};
}
}  // namespace move_base
