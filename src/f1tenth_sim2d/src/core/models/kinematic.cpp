#include "core/models/kinematic.h"

#include <workspace_support/maths/trigonometry.h>

namespace f1tenth_sim2d
{
Kinematic::Kinematic(const VehicleParameters & p) : wheelbase_(p.wheelbase()), rear_share_(p.l_r / p.wheelbase()) {}

// Of the velocity after contacts, the part along the track is kept.
void Kinematic::advance(BodyState & state, const SteeredInput & input, double dt)
{
  const BodyState before = state;
  state.delta += input.steering_rate * dt;
  const maths::SineCosine steering = maths::sineCosine(state.delta);
  const double tangent = steering.sine / steering.cosine;
  const double beta = maths::atan2(tangent * rear_share_, 1.0);
  state.v = state.v * maths::sineCosine(state.beta - beta).cosine + input.acceleration * dt;
  state.beta = beta;
  state.psi_dot = state.v * maths::sineCosine(beta).cosine * tangent / wheelbase_;
  moveOn(state, before, dt);
}
}  // namespace f1tenth_sim2d
