#include "core/car/car.h"

#include <algorithm>
#include <cmath>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/ackermann.h"

namespace f1tenth_sim2d
{
Car::Car(
  const CarDescription & description, const VehicleParameters & parameters, const Pose2 & start, std::uint64_t seed,
  std::uint32_t noise_stream)
: parameters_(parameters),
  track_width_(description.track_width),
  wheel_radius_(description.wheel_radius),
  start_(start),
  model_(parameters),
  actuation_(parameters),
  odometry_(parameters, seed, noise_stream)
{
  if (TwistDrive::drives(description)) {
    twist_drive_.emplace(description, parameters);
  }
}

void Car::place(const Pose2 & pose, const Vec2 & velocity, double yaw_rate)
{
  const Pose2 centre = chain(pose, {parameters_.l_r, 0.0, 0.0});
  state_ = {};
  state_.x = centre.x;
  state_.y = centre.y;
  state_.psi = centre.yaw;
  state_.psi_dot = yaw_rate;
  setBodyVelocity(state_, {velocity.x, velocity.y + yaw_rate * parameters_.l_r});
  predicted_ = state_;
  velocity_ = {};
  speed_ = 0.0;
  acceleration_ = {};
  wheel_speeds_ = {};
}

void Car::restart(SimTime now)
{
  place(start_);
  wheel_angles_ = {};
  actuation_ = Actuation(parameters_);
  if (twist_drive_) {
    twist_drive_->restart();
  }
  odometry_.restart(start_, 0.0, now);
}

void Car::command(const DriveCommand & command, SimTime now)
{
  if (twist_drive_) {
    twist_drive_->command(twistFromCommand(command, parameters_.wheelbase()), now);
  } else {
    actuation_.command(command, now);
  }
}

void Car::commandTwist(const TwistCommand & command, SimTime now)
{
  if (twist_drive_) {
    twist_drive_->command(command, now);
  } else {
    actuation_.command(commandFromTwist(command.velocity.x, command.yaw_rate, parameters_.wheelbase()), now);
  }
}

void Car::predict(SimTime now, double dt)
{
  predicted_ = state_;
  if (twist_drive_) {
    twist_drive_->advance(predicted_, now, dt);
  } else {
    model_.advance(predicted_, actuation_.input(state_, now, dt), dt);
  }
}

double Car::predictedTravel(double outer_radius) const
{
  return length({predicted_.x - state_.x, predicted_.y - state_.y}) +
         std::abs(predicted_.psi - state_.psi) * outer_radius;
}

PlanarMotion Car::predictedMotion() const
{
  return {{state_.x, state_.y, state_.psi}, worldVelocity(predicted_), predicted_.psi_dot};
}

void Car::apply(const ContactEffect & effect)
{
  const Vec2 before = worldVelocity(predicted_);
  predicted_.x = state_.x + effect.displacement.x;
  predicted_.y = state_.y + effect.displacement.y;
  predicted_.psi = state_.psi + effect.displacement.yaw;
  predicted_.psi_dot += effect.yaw_rate_change;
  const Vec2 after{before.x + effect.velocity_change.x, before.y + effect.velocity_change.y};
  setBodyVelocity(predicted_, Transform2({0.0, 0.0, predicted_.psi}).rotateBack(after));
}

void Car::commit(SimTime now, double dt)
{
  const double turn = predicted_.psi - state_.psi;
  state_ = predicted_;
  const Vec2 velocity = worldVelocity(state_);
  const double speed = bodyVelocity(state_).x;
  acceleration_ = {(velocity.x - velocity_.x) / dt, (velocity.y - velocity_.y) / dt};
  const double distance = 0.5 * (speed_ + speed) * dt;
  if (twist_drive_) {
    const double sideways = (bodyVelocity(state_).y - parameters_.l_r * state_.psi_dot) * dt;
    odometry_.advanceFreely({distance, sideways}, turn, track_width_, dt, now);
  } else {
    odometry_.advance(distance, state_.delta, dt, now);
  }
  velocity_ = velocity;
  speed_ = speed;
  turnWheels(dt);
}

void Car::turnWheels(double dt)
{
  wheel_speeds_ =
    wheelSpeeds(speed_, state_.psi_dot, state_.delta, parameters_.wheelbase(), track_width_, wheel_radius_);
  for (std::size_t i = 0; i < wheel_angles_.size(); ++i) {
    wheel_angles_[i] += wheel_speeds_[i] * dt;
  }
}

Pose2 Car::pose() const
{
  const SineCosine at = sineCosine(state_.psi);
  return {state_.x - parameters_.l_r * at.cosine, state_.y - parameters_.l_r * at.sine, normalizeAngle(state_.psi)};
}

CarState Car::state() const
{
  const Vec2 velocity = bodyVelocity(state_);
  CarState state;
  state.pose = pose();
  state.velocity = {velocity.x, velocity.y - parameters_.l_r * state_.psi_dot};
  state.yaw_rate = state_.psi_dot;
  state.acceleration = Transform2({0.0, 0.0, state_.psi}).rotateBack(acceleration_);
  state.steering_angle = state_.delta;
  state.wheel_angles = wheel_angles_;
  state.wheel_speeds = wheel_speeds_;
  return state;
}
}  // namespace f1tenth_sim2d
