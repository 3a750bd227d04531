#include "core/car/single_track.h"

#include <algorithm>
#include <cmath>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kGravity = 9.81;           // m/s^2, part of the model: C_S was identified with it
constexpr double kDynamicSpeedMin = 0.1;    // m/s, as in CommonRoad
constexpr double kGripLostSlip = 0.8;       // rad
constexpr double kGripRegainedSlip = 0.2;   // rad, about 1 / C_S: where the linear tyre reaches mu
constexpr double kIntegrationStep = 0.001;  // s, the stiffest case (v = 0.1 m/s) is stable up to 2.5 ms

/// The part of the state that has dynamics of its own; v and delta run linearly within a step.
struct Lateral
{
  double psi;
  double psi_dot;
  double beta;
};

Lateral operator+(const Lateral & a, const Lateral & b)
{
  return {a.psi + b.psi, a.psi_dot + b.psi_dot, a.beta + b.beta};
}

Lateral operator*(double s, const Lateral & a)
{
  return {s * a.psi, s * a.psi_dot, s * a.beta};
}
}  // namespace

Vec2 bodyVelocity(const SingleTrackState & state)
{
  const SineCosine at = sineCosine(state.beta);
  return {state.v * at.cosine, state.v * at.sine};
}

Vec2 worldVelocity(const SingleTrackState & state)
{
  const SineCosine course = sineCosine(state.psi + state.beta);
  return {state.v * course.cosine, state.v * course.sine};
}

void setBodyVelocity(SingleTrackState & state, const Vec2 & velocity)
{
  const double sign = velocity.x < 0.0 ? -1.0 : 1.0;
  state.v = sign * length(velocity);
  state.beta = direction(sign * velocity.y, sign * velocity.x);
}

SingleTrack::SingleTrack(const VehicleParameters & p)
: m_(p.m),
  I_z_(p.I_z),
  l_f_(p.l_f),
  l_r_(p.l_r),
  wheelbase_(p.wheelbase()),
  h_(p.h),
  front_stiffness_(p.mu * p.C_Sf / p.wheelbase()),
  rear_stiffness_(p.mu * p.C_Sr / p.wheelbase()),
  front_grip_(p.mu * p.m * kGravity * p.l_r / p.wheelbase()),
  rear_grip_(p.mu * p.m * kGravity * p.l_f / p.wheelbase())
{
}

void SingleTrack::advance(SingleTrackState & state, const SingleTrackInput & input, double dt) const
{
  const int count = std::max(1, static_cast<int>(std::ceil(dt / kIntegrationStep - 1e-9)));
  const double step = dt / count;
  for (int i = 0; i < count; ++i) {
    if (isDynamic(state)) {
      advanceDynamic(state, input, step);
    } else {
      advanceWithGrip(state, input, step);
    }
  }
}

bool SingleTrack::isDynamic(SingleTrackState & state) const
{
  if (state.v < kDynamicSpeedMin) {
    state.sliding = false;
    return false;
  }
  const double front_slip = state.delta - state.beta - l_f_ * state.psi_dot / state.v;
  const double rear_slip = l_r_ * state.psi_dot / state.v - state.beta;
  const double slip = std::max(std::abs(front_slip), std::abs(rear_slip));
  state.sliding = slip > (state.sliding ? kGripRegainedSlip : kGripLostSlip);
  return !state.sliding;
}

// Classical Runge-Kutta for the lateral dynamics; the position is their Simpson quadrature, which is what
// Runge-Kutta would do with it at the price of one more sine and cosine.
void SingleTrack::advanceDynamic(SingleTrackState & state, const SingleTrackInput & input, double dt) const
{
  const double front = front_stiffness_ * (kGravity * l_r_ - input.acceleration * h_);
  const double rear = rear_stiffness_ * (kGravity * l_f_ + input.acceleration * h_);
  const double yaw_gain = m_ / I_z_;
  const auto derivative = [&](const Lateral & s, double v, double delta) -> Lateral {
    const double inverse_v = 1.0 / v;
    const double front_force = front * (delta - s.beta - l_f_ * s.psi_dot * inverse_v);
    const double rear_force = rear * (l_r_ * s.psi_dot * inverse_v - s.beta);
    return {
      s.psi_dot, yaw_gain * (l_f_ * front_force - l_r_ * rear_force),
      (front_force + rear_force) * inverse_v - s.psi_dot};
  };

  const double half = 0.5 * dt;
  const double v_mid = state.v + half * input.acceleration;
  const double v_end = state.v + dt * input.acceleration;
  const double delta_mid = state.delta + half * input.steering_rate;
  const double delta_end = state.delta + dt * input.steering_rate;
  const Lateral start{state.psi, state.psi_dot, state.beta};
  const Lateral k1 = derivative(start, state.v, state.delta);
  const Lateral k2 = derivative(start + half * k1, v_mid, delta_mid);
  const Lateral k3 = derivative(start + half * k2, v_mid, delta_mid);
  const Lateral k4 = derivative(start + dt * k3, v_end, delta_end);
  const Lateral middle = start + (0.5 * half) * (k2 + k3);
  const Lateral end = start + (dt / 6.0) * (k1 + 2.0 * (k2 + k3) + k4);

  const SineCosine course_start = sineCosine(start.psi + start.beta);
  const SineCosine course_mid = sineCosine(middle.psi + middle.beta);
  const SineCosine course_end = sineCosine(end.psi + end.beta);
  const double sixth = dt / 6.0;
  state.x += sixth * (state.v * course_start.cosine + 4.0 * v_mid * course_mid.cosine + v_end * course_end.cosine);
  state.y += sixth * (state.v * course_start.sine + 4.0 * v_mid * course_mid.sine + v_end * course_end.sine);
  state.delta = delta_end;
  state.v = v_end;
  state.psi = end.psi;
  state.psi_dot = end.psi_dot;
  state.beta = end.beta;
}

// When one axle cannot deliver what is wanted, the other one still stops its own slip as far as it can.
SingleTrack::AxleForces SingleTrack::limitedForces(
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
void SingleTrack::advanceWithGrip(SingleTrackState & state, const SingleTrackInput & input, double dt) const
{
  const Vec2 before = bodyVelocity(state);
  const Vec2 world_before = worldVelocity(state);
  const double yaw_rate_before = state.psi_dot;
  const double lateral_free = before.y - before.x * yaw_rate_before * dt;
  const double longitudinal_free = before.x + (before.y * yaw_rate_before + input.acceleration) * dt;

  state.delta += input.steering_rate * dt;
  const SineCosine steering = sineCosine(state.delta);
  const double tangent = steering.sine / steering.cosine;
  const double beta = direction(tangent * l_r_ / wheelbase_, 1.0);
  const SineCosine slip = sineCosine(beta);
  const double v = state.v * sineCosine(state.beta - beta).cosine + input.acceleration * dt;
  const double yaw_rate = v * slip.cosine * tangent / wheelbase_;
  const double lateral_change = v * slip.sine - lateral_free;
  const double yaw_rate_change = yaw_rate - yaw_rate_before;
  const double front = (l_r_ * m_ * lateral_change + I_z_ * yaw_rate_change) / (wheelbase_ * dt);
  const double rear = (l_f_ * m_ * lateral_change - I_z_ * yaw_rate_change) / (wheelbase_ * dt);

  if (std::abs(front) <= front_grip_ && std::abs(rear) <= rear_grip_) {
    state.v = v;
    state.beta = beta;
    state.psi_dot = yaw_rate;
  } else {
    const double front_slip_free = lateral_free + l_f_ * yaw_rate_before - longitudinal_free * tangent;
    const AxleForces forces = limitedForces({front, rear}, front_slip_free, lateral_free - l_r_ * yaw_rate_before, dt);
    setBodyVelocity(state, {longitudinal_free, lateral_free + (forces.front + forces.rear) * dt / m_});
    state.psi_dot += (l_f_ * forces.front - l_r_ * forces.rear) * dt / I_z_;
  }
  state.psi += 0.5 * dt * (yaw_rate_before + state.psi_dot);
  const Vec2 world_after = worldVelocity(state);
  state.x += 0.5 * dt * (world_before.x + world_after.x);
  state.y += 0.5 * dt * (world_before.y + world_after.y);
}
}  // namespace f1tenth_sim2d
