#include "core/models/body_state.h"

#include <workspace_support/maths/trigonometry.h>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
Vec2 bodyVelocity(const BodyState & state)
{
  const maths::SineCosine at = maths::sineCosine(state.beta);
  return {state.v * at.cosine, state.v * at.sine};
}

Vec2 worldVelocity(const BodyState & state)
{
  const maths::SineCosine course = maths::sineCosine(state.psi + state.beta);
  return {state.v * course.cosine, state.v * course.sine};
}

void setBodyVelocity(BodyState & state, const Vec2 & velocity)
{
  const double sign = velocity.x < 0.0 ? -1.0 : 1.0;
  state.v = sign * length(velocity);
  state.beta = maths::atan2(sign * velocity.y, sign * velocity.x);
}

void moveOn(BodyState & state, const BodyState & before, double dt)
{
  const Vec2 world_before = worldVelocity(before);
  state.psi += 0.5 * dt * (before.psi_dot + state.psi_dot);
  const Vec2 world_after = worldVelocity(state);
  state.x += 0.5 * dt * (world_before.x + world_after.x);
  state.y += 0.5 * dt * (world_before.y + world_after.y);
}
}  // namespace f1tenth_sim2d
