#include "control/speed_lag.h"

#include <algorithm>
#include <cmath>

namespace move_base
{
namespace
{
constexpr double kDelayStep = 0.025;     // s, between the delays that are compared
constexpr double kGreatest = 0.35;       // s
constexpr double kLeastChange = 0.3;     // m/s, that a command must change by to tell something
constexpr double kChangeTime = 0.25;     // s, within which
constexpr double kLagForgetting = 0.01;  // per measurement
constexpr double kExpectation = 0.01;    // m^2/s^2, error taken for a delay one step beside the expected one
constexpr std::size_t kDelays = static_cast<std::size_t>(kGreatest / kDelayStep) + 1;
}  // namespace

SpeedLag::SpeedLag(double expected) : errors_(kDelays)
{
  for (std::size_t i = 0; i < kDelays; ++i) {
    errors_[i] = kExpectation * std::pow(static_cast<double>(i) - expected / kDelayStep, 2);
  }
}

void SpeedLag::noteCommand(double time, double speed)
{
  if (!commands_.empty() && time < commands_.back().time) {
    commands_.clear();
  }
  commands_.push_back({time, speed});
  while (commands_.front().time < time - kGreatest - kChangeTime) {
    commands_.pop_front();
  }
}

void SpeedLag::noteSpeed(double time, double speed)
{
  const bool changes = std::abs(commandAt(time) - commandAt(time - kChangeTime)) > kLeastChange;
  if (!changes || speed < 0.0) {
    return;
  }
  for (std::size_t i = 0; i < kDelays; ++i) {
    const double error = speed - commandAt(time - kDelayStep * static_cast<double>(i));
    errors_[i] += error * error - kLagForgetting * errors_[i];
  }
}

// The place of the parabola's bottom through the least error and those beside it.
double SpeedLag::lag() const
{
  const auto least = std::min_element(errors_.begin() + 1, errors_.end() - 1);
  const double before = *(least - 1) - *least;
  const double after = *(least + 1) - *least;
  const double beside = before + after > 0.0 ? std::clamp(0.5 * (before - after) / (before + after), -1.0, 1.0) : 0.0;
  return kDelayStep * (static_cast<double>(least - errors_.begin()) + beside);
}

double SpeedLag::commandAt(double time) const
{
  constexpr double kSameTime = 1e-6;  // s
  const auto later =
    std::find_if(commands_.begin(), commands_.end(), [&](const auto & each) { return each.time > time + kSameTime; });
  return later == commands_.begin() ? 0.0 : std::prev(later)->speed;
}
}  // namespace move_base
