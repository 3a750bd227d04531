#include "f1tenth_sim2d/ackermann.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

namespace f1tenth_sim2d
{
namespace maths = workspace_support::maths;

namespace
{
double tangentOf(double angle)
{
  const maths::SineCosine at = maths::sineCosine(angle);
  return at.sine / at.cosine;
}

/// Tangent of the steering angle of a front wheel at lateral offset y from the middle of the car.
double tangentAt(double y, double tangent, double wheelbase)
{
  return tangent / (1.0 - tangent * y / wheelbase);
}
}  // namespace

SteeringAngles ackermannSteering(double steering_angle, double wheelbase, double track_width)
{
  const double tangent = tangentOf(steering_angle);
  return {
    maths::atan2(tangentAt(0.5 * track_width, tangent, wheelbase), 1.0),
    maths::atan2(tangentAt(-0.5 * track_width, tangent, wheelbase), 1.0)};
}

std::array<double, 4> wheelSpeeds(
  double speed, double yaw_rate, double steering_angle, double wheelbase, double track_width, double wheel_radius)
{
  const double tangent = tangentOf(steering_angle);
  const auto front = [&](double y) {
    const double t = tangentAt(y, tangent, wheelbase);
    return (speed - yaw_rate * y + yaw_rate * wheelbase * t) / std::sqrt(1.0 + t * t) / wheel_radius;
  };
  const auto rear = [&](double y) { return (speed - yaw_rate * y) / wheel_radius; };
  const double y = 0.5 * track_width;
  return {front(y), front(-y), rear(y), rear(-y)};
}
}  // namespace f1tenth_sim2d
