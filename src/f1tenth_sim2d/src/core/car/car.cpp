#include "core/car/car.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>

#include "core/car/steered_drive.h"
#include "core/car/twist_drive.h"
#include "core/math/planar_pose.h"
#include "core/models/kinematic.h"
#include "core/models/single_track.h"
#include "core/models/single_track_drift.h"
#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
std::unique_ptr<SteeredModel> makeModel(const VehicleParameters & parameters)
{
  switch (parameters.model) {
    case VehicleModel::kKinematic:
      return std::make_unique<Kinematic>(parameters);
    case VehicleModel::kSingleTrackDrift:
      return std::make_unique<SingleTrackDrift>(parameters);
    case VehicleModel::kSingleTrack:
      return std::make_unique<SingleTrack>(parameters);
  }
  throw Error("a car has no model");
}

/// The dynamics that a car's description and the `model` of its parameters ask for.
std::unique_ptr<VehicleDynamics> makeVehicleDynamics(const CarDescription & car, const VehicleParameters & parameters)
{
  if (TwistDrive::drives(car)) {
    return std::make_unique<TwistDrive>(car, parameters);
  }
  return std::make_unique<SteeredDrive>(car, parameters, makeModel(parameters));
}
}  // namespace

Car::Car(
  const CarDescription & description, const VehicleParameters & parameters, const Pose2 & start, std::uint64_t seed,
  std::uint32_t noise_stream)
: parameters_(parameters),
  start_(start),
  dynamics_(makeVehicleDynamics(description, parameters)),
  odometry_(parameters, dynamics_->steers(), description.track_width, seed, noise_stream)
{
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
  dynamics_->place(state_);
  velocity_ = worldVelocity(state_);
  acceleration_ = {};
  const WheelMotion wheels = dynamics_->wheels(state_);
  rolling_speed_ = wheels.rear_speed;
  wheel_speeds_ = wheels.speeds;
}

void Car::restart(SimTime now)
{
  place(start_);
  wheel_angles_ = {};
  dynamics_->restart();
  odometry_.restart(start_, now);
}

void Car::predict(SimTime now, double dt)
{
  predicted_ = state_;
  dynamics_->advance(predicted_, rolling_speed_, now, dt);
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
  setBodyVelocity(predicted_, Transform2({0.0, 0.0, predicted_.psi}).rotateBack(before + effect.velocity_change));
}

void Car::commit(SimTime now, double dt)
{
  const double turn = predicted_.psi - state_.psi;
  state_ = predicted_;
  const Vec2 velocity = worldVelocity(state_);
  const WheelMotion wheels = dynamics_->wheels(state_);
  acceleration_ = {(velocity.x - velocity_.x) / dt, (velocity.y - velocity_.y) / dt};
  odometry_.advance(state_, 0.5 * (rolling_speed_ + wheels.rear_speed) * dt, turn, dt, now);
  velocity_ = velocity;
  rolling_speed_ = wheels.rear_speed;
  wheel_speeds_ = wheels.speeds;
  for (std::size_t i = 0; i < wheel_angles_.size(); ++i) {
    wheel_angles_[i] += wheel_speeds_[i] * dt;
  }
}

Pose2 Car::pose() const
{
  const maths::SineCosine at = maths::sineCosine(state_.psi);
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
