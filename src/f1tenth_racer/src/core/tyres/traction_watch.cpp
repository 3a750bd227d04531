#include "tyres/traction_watch.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_racer
{
namespace
{
constexpr double kStill = 0.1;           // m/s; slower, something holds the car
constexpr double kBehind = 0.4;          // m/s, behind its command
constexpr double kFastest = 4.0;         // m/s; faster, the motor's power may be what it lacks
constexpr double kCornering = 1.0;       // m/s^2, to the side; more takes grip away
constexpr double kAnswer = 0.5;          // s, until every car follows
constexpr double kTractionWindow = 0.2;  // s, over which its acceleration is measured
constexpr double kLeast = 0.25;          // of the commanded acceleration
}  // namespace

void TractionWatch::noteSpeed(double time, double speed)
{
  if (!behind_.empty() && time <= behind_.back().time) {
    if (time < behind_.back().time) {
      behind_.clear();
    }
    return;
  }
  const bool corners = speed * speed * std::abs(command_.curvature) > kCornering;
  if (command_.speed - speed < kBehind || speed < kStill || speed > kFastest || corners) {
    behind_.clear();
    return;
  }
  behind_.push_back({time, speed});
  if (time - behind_.front().time < kAnswer) {
    return;
  }
  const auto before = std::find_if(
    behind_.rbegin(), behind_.rend(), [&](const Speed & each) { return each.time <= time - kTractionWindow; });
  const double acceleration = (speed - before->speed) / (time - before->time);
  share_ = std::clamp(acceleration / told_, kLeast, 1.0);
}
}  // namespace f1tenth_racer
