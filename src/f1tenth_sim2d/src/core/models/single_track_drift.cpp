#include "core/models/single_track_drift.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kRest = 1e-9;            // m/s and rad/s, below which a car stands
constexpr double kSlidingSpeedMin = 0.2;  // m/s, where CommonRoad's model is halfway over to the kinematic one
/// How much of a rate of decay (its product with the step) the method ROS2 takes implicitly: without overshoot where it
/// is stiff, and close to the exponential where it is not.
double implicitShare(double decay)
{
  constexpr double kGamma = 1.7071067811865475;  // 1 + sqrt(1/2)
  return std::min(0.5 * decay, kGamma);
}
}  // namespace

SingleTrackDrift::Motion operator+(const SingleTrackDrift::Motion & a, const SingleTrackDrift::Motion & b)
{
  return {a.v_x + b.v_x, a.v_y + b.v_y, a.psi_dot + b.psi_dot, a.omega_f + b.omega_f, a.omega_r + b.omega_r};
}

SingleTrackDrift::Motion operator*(double s, const SingleTrackDrift::Motion & a)
{
  return {s * a.v_x, s * a.v_y, s * a.psi_dot, s * a.omega_f, s * a.omega_r};
}

SingleTrackDrift::SingleTrackDrift(const VehicleParameters & p)
: m_(p.m),
  I_z_(p.I_z),
  l_f_(p.l_f),
  l_r_(p.l_r),
  h_(p.h),
  wheelbase_(p.wheelbase()),
  R_w_(p.R_w),
  I_y_w_(p.I_y_w),
  brake_split_(p.T_sb),
  engine_split_(p.T_se),
  grip_(p.mu * kGravity),
  tyre_(p),
  low_speed_(p)
{
}

void SingleTrackDrift::restart(const BodyState & state)
{
  roll(state);
}

/// Lets the wheels roll without slip.
void SingleTrackDrift::roll(const BodyState & state)
{
  const Vec2 velocity = bodyVelocity(state);
  const Vec2 front{velocity.x, velocity.y + l_f_ * state.psi_dot};
  omega_f_ = WheelFooting(front, maths::sineCosine(state.delta)).along / R_w_;
  omega_r_ = velocity.x / R_w_;
}

std::optional<AxleSpeeds> SingleTrackDrift::axleSpeeds() const
{
  const double front = R_w_ * omega_f_;
  const double rear = R_w_ * omega_r_;
  return AxleSpeeds{front, rear, engine_split_ * front + (1.0 - engine_split_) * rear};
}

void SingleTrackDrift::advance(BodyState & state, const SteeredInput & input, double dt)
{
  inShortSteps(dt, [&](double step) {
    if (std::abs(state.v) < kSlidingSpeedMin) {
      low_speed_.advance(state, {input.steering_rate, std::clamp(input.acceleration, -grip_, grip_)}, step);
      if (std::abs(state.v) < kRest && std::abs(state.psi_dot) < kRest) {
        state.v = 0.0;
        state.psi_dot = 0.0;
      }
      roll(state);
    } else {
      advanceSliding(state, input, step);
    }
  });
}

// The method ROS2 of J. G. Verwer et al. (A second-order Rosenbrock method applied to photochemical dispersion
// problems, 1999): of second order whatever matrix it is given, and stable for the stiff part that the matrix holds,
// which here are tyres at low speed. The position follows by the trapezoidal rule.
void SingleTrackDrift::advanceSliding(BodyState & state, const SteeredInput & input, double dt)
{
  const BodyState before = state;
  const Vec2 velocity = bodyVelocity(before);
  const Motion start{velocity.x, velocity.y, state.psi_dot, omega_f_, omega_r_};
  const Torques applied = torques(start, input.acceleration);
  const maths::SineCosine steering = maths::sineCosine(state.delta);
  const Footing first = footing(start, steering, input.acceleration);
  const Damping losses = damping(first, dt);
  const Motion k1 = damped(slope(start, first, steering, applied), losses, steering);

  state.delta += input.steering_rate * dt;
  const maths::SineCosine steered = maths::sineCosine(state.delta);
  const Motion ahead = braked(start + dt * k1, applied);
  const Footing second = footing(ahead, steered, input.acceleration);
  const Motion k2 = damped(slope(ahead, second, steered, applied) + -2.0 * k1, losses, steering);

  const Motion end = braked(start + (1.5 * dt) * k1 + (0.5 * dt) * k2, applied);
  omega_f_ = end.omega_f;
  omega_r_ = end.omega_r;
  setBodyVelocity(state, {end.v_x, end.v_y});
  state.psi_dot = end.psi_dot;
  moveOn(state, before, dt);
}

// Brakes stop a wheel, but do not turn it.
SingleTrackDrift::Motion SingleTrackDrift::braked(const Motion & motion, const Torques & torques)
{
  const auto held = [&](double omega) { return torques.brake && omega * motion.v_x < 0.0 ? 0.0 : omega; };
  return {motion.v_x, motion.v_y, motion.psi_dot, held(motion.omega_f), held(motion.omega_r)};
}

SingleTrackDrift::Torques SingleTrackDrift::torques(const Motion & motion, double acceleration) const
{
  const bool brake = acceleration * motion.v_x < 0.0;
  const double split = brake ? brake_split_ : engine_split_;
  const double torque = m_ * R_w_ * acceleration;
  return {split * torque, (1.0 - split) * torque, brake};
}

SingleTrackDrift::Footing SingleTrackDrift::footing(
  const Motion & motion, const maths::SineCosine & steering, double acceleration) const
{
  Footing footing{
    WheelFooting({motion.v_x, motion.v_y + l_f_ * motion.psi_dot}, steering),
    WheelFooting({motion.v_x, motion.v_y - l_r_ * motion.psi_dot}, maths::SineCosine{0.0, 1.0})};
  const auto push = [&](WheelFooting & wheels, double omega, double load) {
    wheels.forces = tyre_.forces(wheels.slip(R_w_ * omega), wheels.angle(), std::max(load, 0.0));
  };
  push(footing.front, motion.omega_f, m_ * (kGravity * l_r_ - acceleration * h_) / wheelbase_);
  push(footing.rear, motion.omega_r, m_ * (kGravity * l_f_ + acceleration * h_) / wheelbase_);
  return footing;
}

SingleTrackDrift::Motion SingleTrackDrift::slope(
  const Motion & motion, const Footing & footing, const maths::SineCosine & steering, const Torques & torques) const
{
  const double front_along = footing.front.forces.along.value;
  const double front_aside = footing.front.forces.aside.value;
  const double rear_along = footing.rear.forces.along.value;
  const double rear_aside = footing.rear.forces.aside.value;
  const double front_x = front_along * steering.cosine - front_aside * steering.sine;
  const double front_y = front_along * steering.sine + front_aside * steering.cosine;
  const auto spin = [&](double omega, double torque) {
    const bool is_held = torques.brake && omega == 0.0 && torque * motion.v_x < 0.0;
    return is_held ? 0.0 : torque / I_y_w_;
  };
  return {
    (front_x + rear_along) / m_ + motion.v_y * motion.psi_dot,
    (front_y + rear_aside) / m_ - motion.v_x * motion.psi_dot, (l_f_ * front_y - l_r_ * rear_aside) / I_z_,
    spin(motion.omega_f, torques.front - R_w_ * front_along), spin(motion.omega_r, torques.rear - R_w_ * rear_along)};
}

SingleTrackDrift::Damping SingleTrackDrift::damping(const Footing & footing, double dt) const
{
  const auto wheel = [&](const WheelFooting & wheels) {
    const double push = R_w_ * wheels.alongDamping();
    return implicitShare(R_w_ * push / I_y_w_ * dt) * dt * push;
  };
  const double front = footing.front.asideDamping();
  const double rear = footing.rear.asideDamping();
  const double aside = (front + rear) / m_ * dt;
  const double turning = (l_f_ * l_f_ * front + l_r_ * l_r_ * rear) / I_z_ * dt;
  return {wheel(footing.front), wheel(footing.rear), implicitShare(aside) * aside, implicitShare(turning) * turning};
}

// The extra push of the tyres when the wheels turn faster also moves the car, or momentum would come from nowhere.
SingleTrackDrift::Motion SingleTrackDrift::damped(
  const Motion & slope, const Damping & damping, const maths::SineCosine & steering) const
{
  const double spin_f = slope.omega_f / (1.0 + R_w_ * damping.front_wheel / I_y_w_);
  const double spin_r = slope.omega_r / (1.0 + R_w_ * damping.rear_wheel / I_y_w_);
  const double front = damping.front_wheel * spin_f;
  const double rear = damping.rear_wheel * spin_r;
  return {
    slope.v_x + (front * steering.cosine + rear) / m_, (slope.v_y + front * steering.sine / m_) / (1.0 + damping.aside),
    (slope.psi_dot + l_f_ * front * steering.sine / I_z_) / (1.0 + damping.turning), spin_f, spin_r};
}
}  // namespace f1tenth_sim2d
