#pragma once

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
/// Motion of a car in the plane, whatever moves it. The reference point is the centre of mass.
struct BodyState
{
  double x{0.0};        ///< m
  double y{0.0};        ///< m
  double delta{0.0};    ///< rad, steering angle of the single-track front wheel
  double v{0.0};        ///< m/s, speed of the centre of mass, negative in reverse
  double psi{0.0};      ///< rad, yaw, not wrapped
  double psi_dot{0.0};  ///< rad/s
  double beta{0.0};     ///< rad, slip angle at the centre of mass, within +-pi/2
};

/// Velocity of the centre of mass in the frame of the car, m/s.
Vec2 bodyVelocity(const BodyState & state);
/// The same in the world.
Vec2 worldVelocity(const BodyState & state);
/// Sets v and beta from the velocity of the centre of mass in the frame of the car, m/s.
void setBodyVelocity(BodyState & state, const Vec2 & velocity);
/// Advances heading and position by dt seconds by the trapezoidal rule, with the velocities before and those set now.
void moveOn(BodyState & state, const BodyState & before, double dt);
}  // namespace f1tenth_sim2d
