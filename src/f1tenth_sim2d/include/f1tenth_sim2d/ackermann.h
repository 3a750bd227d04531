#pragma once

#include <array>

namespace f1tenth_sim2d
{
/// Steering angles of the two front wheels, rad, positive to the left.
struct SteeringAngles
{
  double left{0.0};
  double right{0.0};
};

/// Ackermann geometry: all wheels roll about one point on the line of the rear axle.
/// @param steering_angle  of the single-track front wheel, rad, within +-pi/2
/// @param wheelbase       m
/// @param track_width     m, between the steering joints; narrower than the turning circle
SteeringAngles ackermannSteering(double steering_angle, double wheelbase, double track_width);

/// Rolling speeds of the wheels, rad/s: front left, front right, rear left, rear right.
/// @param speed     m/s, of the middle of the rear axle along the car
/// @param yaw_rate  rad/s
std::array<double, 4> wheelSpeeds(
  double speed, double yaw_rate, double steering_angle, double wheelbase, double track_width, double wheel_radius);
}  // namespace f1tenth_sim2d
