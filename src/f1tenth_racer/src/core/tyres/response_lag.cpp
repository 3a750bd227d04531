#include "tyres/response_lag.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kDelayStep = 0.025;  // s, between the delays that are compared
constexpr std::size_t kDelays = 15;
constexpr double kGreatest = kDelayStep * static_cast<double>(kDelays - 1);
constexpr double kChangeTime = 0.25;     // s, within which a command must change
constexpr double kLagForgetting = 0.01;  // per measurement
constexpr double kExpectation = 0.1;     // of the least change squared, error taken for a delay one step off
}  // namespace

ResponseLag::ResponseLag(double least_change)
: least_change_(least_change), errors_(kDelays), expectation_(kExpectation * least_change * least_change)
{
}

void ResponseLag::noteCommand(double time, double value)
{
  if (!commands_.empty() && time < commands_.back().time) {
    commands_.clear();
  }
  commands_.push_back({time, value});
  while (commands_.front().time < time - kGreatest - kChangeTime) {
    commands_.pop_front();
  }
}

void ResponseLag::noteAnswer(double time, double value)
{
  if (std::abs(commandAt(time) - commandAt(time - kChangeTime)) <= least_change_) {
    return;
  }
  for (std::size_t i = 0; i < kDelays; ++i) {
    const double error = value - commandAt(time - kDelayStep * static_cast<double>(i));
    errors_[i] += error * error - kLagForgetting * errors_[i];
  }
  expectation_ -= kLagForgetting * expectation_;
}

// The place of the minimum of the parabola through the least error and those beside it.
double ResponseLag::lag(double expected) const
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < kDelays; ++i) {
    const double off = static_cast<double>(i) - expected / kDelayStep;
    errors.push_back(errors_[i] + expectation_ * off * off);
  }
  const auto least = std::min_element(errors.begin() + 1, errors.end() - 1);
  const double before = *(least - 1) - *least;
  const double after = *(least + 1) - *least;
  const double beside = before + after > 0.0 ? std::clamp(0.5 * (before - after) / (before + after), -1.0, 1.0) : 0.0;
  return kDelayStep * (static_cast<double>(least - errors.begin()) + beside);
}

double ResponseLag::commandAt(double time) const
{
  constexpr double kSameTime = 1e-6;  // s
  const auto later =
    std::find_if(commands_.begin(), commands_.end(), [&](const auto & each) { return each.time > time + kSameTime; });
  return later == commands_.begin() ? 0.0 : std::prev(later)->value;
}
}  // namespace f1tenth_racer
