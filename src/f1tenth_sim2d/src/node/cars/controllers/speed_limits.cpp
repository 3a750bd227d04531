#include "node/cars/controllers/speed_limits.h"

#include <algorithm>

namespace f1tenth_sim2d
{
namespace
{
double clamped(double value, const SpeedLimits::Range & range, double scale)
{
  return std::clamp(value, range.least * scale, range.greatest * scale);
}
}  // namespace

double limited(double wanted, double last, double before, double dt, const SpeedLimits & limits)
{
  double value = wanted;
  if (limits.jerk) {
    const double change = last - before;
    // The original's factor: the change of a change within dt, twice.
    value = last + change + clamped(value - last - change, *limits.jerk, 2.0 * dt * dt);
  }
  if (limits.acceleration) {
    value = last + clamped(value - last, *limits.acceleration, dt);
  }
  return limits.velocity ? clamped(value, *limits.velocity, 1.0) : value;
}
}  // namespace f1tenth_sim2d
