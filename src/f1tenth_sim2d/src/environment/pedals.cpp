#include "environment/pedals.h"

#include <algorithm>

namespace f1tenth_sim2d
{
Pedals::Pedals(const VehicleParameters & parameters, double speed) : parameters_(parameters), speed_(speed) {}

DriveCommand Pedals::press(const CarState & state, double steering_rate, double acceleration, double dt)
{
  const double rate = std::clamp(steering_rate, -parameters_.steering_rate_max, parameters_.steering_rate_max);
  const double limit = parameters_.steering_max;
  steering_angle_ = std::clamp(steering_angle_ + rate * dt, -limit, limit);

  const double a = std::clamp(acceleration, -parameters_.a_max, parameters_.a_max);
  // A car that cannot follow, in front of a wall or above v_switch, must not run up speed that it would then catch up with.
  const double lag = parameters_.a_max * (parameters_.actuation_latency + 1.0 / parameters_.speed_gain);
  speed_ = std::clamp(speed_ + a * dt, state.velocity.x - lag, state.velocity.x + lag);
  speed_ = std::clamp(speed_, parameters_.v_min, parameters_.v_max);
  // The car accelerates by its speed error times the gain: with this lead it follows a ramp without falling behind.
  return {speed_ + a / parameters_.speed_gain, steering_angle_};
}
}  // namespace f1tenth_sim2d
