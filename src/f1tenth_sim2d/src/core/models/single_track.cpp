#include "core/models/single_track.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
constexpr double kDynamicSpeedMin = 0.1;   // m/s, as in CommonRoad
constexpr double kGripLostSlip = 0.8;      // rad
constexpr double kGripRegainedSlip = 0.2;  // rad, about 1 / C_S: where the linear tyre reaches mu

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

SingleTrack::SingleTrack(const VehicleParameters & p)
: m_(p.m),
  I_z_(p.I_z),
  l_f_(p.l_f),
  l_r_(p.l_r),
  h_(p.h),
  front_stiffness_(p.mu * p.C_Sf / p.wheelbase()),
  rear_stiffness_(p.mu * p.C_Sr / p.wheelbase()),
  low_speed_(p)
{
}

void SingleTrack::restart(const BodyState & /*state*/)
{
  sliding_ = false;
}

void SingleTrack::advance(BodyState & state, const SteeredInput & input, double dt)
{
  inShortSteps(dt, [&](double step) {
    if (isDynamic(state)) {
      advanceDynamic(state, input, step);
    } else {
      low_speed_.advance(state, input, step);
    }
  });
}

bool SingleTrack::isDynamic(const BodyState & state)
{
  if (state.v < kDynamicSpeedMin) {
    sliding_ = false;
    return false;
  }
  const double front_slip = state.delta - state.beta - l_f_ * state.psi_dot / state.v;
  const double rear_slip = l_r_ * state.psi_dot / state.v - state.beta;
  const double slip = std::max(std::abs(front_slip), std::abs(rear_slip));
  sliding_ = slip > (sliding_ ? kGripRegainedSlip : kGripLostSlip);
  return !sliding_;
}

// Classical Runge-Kutta for the lateral dynamics; the position is their Simpson quadrature, which is what
// Runge-Kutta would do with it at the price of one more sine and cosine.
void SingleTrack::advanceDynamic(BodyState & state, const SteeredInput & input, double dt) const
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

  const maths::SineCosine course_start = maths::sineCosine(start.psi + start.beta);
  const maths::SineCosine course_mid = maths::sineCosine(middle.psi + middle.beta);
  const maths::SineCosine course_end = maths::sineCosine(end.psi + end.beta);
  const double sixth = dt / 6.0;
  state.x += sixth * (state.v * course_start.cosine + 4.0 * v_mid * course_mid.cosine + v_end * course_end.cosine);
  state.y += sixth * (state.v * course_start.sine + 4.0 * v_mid * course_mid.sine + v_end * course_end.sine);
  state.delta = delta_end;
  state.v = v_end;
  state.psi = end.psi;
  state.psi_dot = end.psi_dot;
  state.beta = end.beta;
}
}  // namespace f1tenth_sim2d
