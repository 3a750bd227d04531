#include "core/models/rolling_with_grip.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
RollingWithGrip::RollingWithGrip(const VehicleParameters & p)
: m_(p.m),
  I_z_(p.I_z),
  l_f_(p.l_f),
  l_r_(p.l_r),
  wheelbase_(p.wheelbase()),
  front_grip_(p.mu * p.m * kGravity * p.l_r / p.wheelbase()),
  rear_grip_(p.mu * p.m * kGravity * p.l_f / p.wheelbase())
{
}

// When one axle cannot deliver what is wanted, the other one still stops its own slip as far as it can.
RollingWithGrip::AxleForces RollingWithGrip::limitedForces(
  const AxleForces & wanted, double front_slip_free, double rear_slip_free, double dt) const
{
  const double coupling = 1.0 / m_ - l_f_ * l_r_ / I_z_;
  AxleForces forces{
    std::clamp(wanted.front, -front_grip_, front_grip_), std::clamp(wanted.rear, -rear_grip_, rear_grip_)};
  if (forces.front != wanted.front) {
    const double force = (-rear_slip_free / dt - coupling * forces.front) / (1.0 / m_ + l_r_ * l_r_ / I_z_);
    forces.rear = std::clamp(force, -rear_grip_, rear_grip_);
  } else if (forces.rear != wanted.rear) {
    const double force = (-front_slip_free / dt - coupling * forces.rear) / (1.0 / m_ + l_f_ * l_f_ / I_z_);
    forces.front = std::clamp(force, -front_grip_, front_grip_);
  }
  return forces;
}

// Kinematic as long as the axles can hold the car on its wheels' track, else sliding: the lateral force of each axle
// that would bring it back on track within the step is limited by Coulomb friction.
void RollingWithGrip::advance(BodyState & state, const SteeredInput & input, double dt) const
{
  const BodyState before = state;
  const Vec2 velocity = bodyVelocity(before);
  const double lateral_free = velocity.y - velocity.x * before.psi_dot * dt;
  const double longitudinal_free = velocity.x + (velocity.y * before.psi_dot + input.acceleration) * dt;

  state.delta += input.steering_rate * dt;
  const maths::SineCosine steering = maths::sineCosine(state.delta);
  const double tangent = steering.sine / steering.cosine;
  const double beta = maths::atan2(tangent * l_r_ / wheelbase_, 1.0);
  const maths::SineCosine slip = maths::sineCosine(beta);
  const double v = state.v * maths::sineCosine(state.beta - beta).cosine + input.acceleration * dt;
  const double yaw_rate = v * slip.cosine * tangent / wheelbase_;
  const double lateral_change = v * slip.sine - lateral_free;
  const double yaw_rate_change = yaw_rate - before.psi_dot;
  const double front = (l_r_ * m_ * lateral_change + I_z_ * yaw_rate_change) / (wheelbase_ * dt);
  const double rear = (l_f_ * m_ * lateral_change - I_z_ * yaw_rate_change) / (wheelbase_ * dt);

  if (std::abs(front) <= front_grip_ && std::abs(rear) <= rear_grip_) {
    state.v = v;
    state.beta = beta;
    state.psi_dot = yaw_rate;
  } else {
    const double front_slip_free = lateral_free + l_f_ * before.psi_dot - longitudinal_free * tangent;
    const AxleForces forces = limitedForces({front, rear}, front_slip_free, lateral_free - l_r_ * before.psi_dot, dt);
    setBodyVelocity(state, {longitudinal_free, lateral_free + (forces.front + forces.rear) * dt / m_});
    state.psi_dot += (l_f_ * forces.front - l_r_ * forces.rear) * dt / I_z_;
  }
  moveOn(state, before, dt);
}
}  // namespace f1tenth_sim2d
