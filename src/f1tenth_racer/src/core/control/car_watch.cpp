#include "control/car_watch.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kMostLatency = 0.15;          // s, beyond that of the options
constexpr double kYawDoubt = 0.03;             // s, by which the yaw may seem to respond too early
constexpr double kLeastSlip = 0.2;             // times that of the options
constexpr double kMostSlip = 4.0;              // the same
constexpr double kLeastSpeedChange = 0.3;      // m/s, in a command, that shows how late the speed follows
constexpr double kLeastCurvatureChange = 0.1;  // 1/m, the same of the yaw
constexpr double kLeastTurnSpeed = 1.5;        // m/s, from which its yaw is informative
constexpr double kLongestTurn = 0.1;           // s, between poses that give a curvature
constexpr double kMostCurvature = 2.0;         // 1/m, beyond it the pose has jumped
}  // namespace

CarWatch::CarWatch(const FollowerOptions & told)
: told_latency_(told.latency),
  told_slip_(told.slip_gradient),
  speed_lag_(kLeastSpeedChange),
  yaw_lag_(kLeastCurvatureChange),
  slip_watch_(told.slip_gradient),
  traction_watch_(told.limits.acc_lim_x)
{
}

CarState CarWatch::note(const CarSighting & sighting, double now)
{
  if (sighting.car.speed >= 0.0) {
    speed_lag_.noteAnswer(sighting.measured, sighting.car.speed);
  }
  noteBend(sighting);
  traction_watch_.noteSpeed(sighting.measured, sighting.car.speed);
  slip_watch_.note(sighting.seen, sighting.car.pose);
  return reckoning_.predict(sighting.car, sighting.seen, sighting.measured, now);
}

void CarWatch::noteBend(const CarSighting & sighting)
{
  const double duration = before_ ? sighting.seen - before_->seen : 0.0;
  if (before_ && duration == 0.0) {
    return;
  }
  if (duration > 0.0 && duration < kLongestTurn && sighting.car.speed > kLeastTurnSpeed) {
    const double turn = normalizeAngle(sighting.car.pose.yaw - before_->car.pose.yaw);
    const double curvature = turn / (duration * sighting.car.speed);
    if (std::abs(curvature) < kMostCurvature) {
      yaw_lag_.noteAnswer(sighting.seen - 0.5 * duration, curvature);
    }
  }
  before_ = sighting;
}

void CarWatch::clear()
{
  reckoning_.clear();
  before_.reset();
}

void CarWatch::noteCommand(double time, const DriveCommand & command, double bend)
{
  reckoning_.note(time, command);
  speed_lag_.noteCommand(time, command.speed);
  yaw_lag_.noteCommand(time, bend);
  traction_watch_.noteCommand(command);
}

// Commands reach motor and steering the same way, but tyres that slide pass on a speed later than a turn.
Lags CarWatch::lags() const
{
  const auto plausible = [&](double latency) {
    return std::clamp(latency, told_latency_, told_latency_ + kMostLatency);
  };
  constexpr double kSpeedLag = Handling::kSpeedLag;
  const double of_speed = plausible(speed_lag_.lag(kSpeedLag + told_latency_) - kSpeedLag);
  const double of_yaw = plausible(yaw_lag_.lag(of_speed - kYawDoubt) + kYawDoubt);
  return {std::min(of_yaw, of_speed), kSpeedLag + of_speed};
}

Tyres CarWatch::tyres() const
{
  if (told_slip_ <= 0.0) {
    return {};
  }
  const double slip = std::clamp(slip_watch_.gradient() / told_slip_, kLeastSlip, kMostSlip);
  return {slip, traction_watch_.share(), slip_watch_.hasFelt()};
}
}  // namespace f1tenth_racer
