#include "core/car/steered_drive.h"

#include <utility>

#include "f1tenth_sim2d/ackermann.h"

namespace f1tenth_sim2d
{
SteeredDrive::SteeredDrive(
  const CarDescription & car, const VehicleParameters & parameters, std::unique_ptr<SteeredModel> model)
: parameters_(parameters),
  track_width_(car.track_width),
  wheel_radius_(car.wheel_radius),
  actuation_(parameters),
  model_(std::move(model))
{
}

void SteeredDrive::restart()
{
  actuation_ = Actuation(parameters_);
}

void SteeredDrive::place(const BodyState & state)
{
  model_->restart(state);
}

void SteeredDrive::command(const DriveCommand & command, SimTime now)
{
  actuation_.command(command, now);
}

void SteeredDrive::command(const TwistCommand & command, SimTime now)
{
  actuation_.command(commandFromTwist(command.velocity.x, command.yaw_rate, parameters_.wheelbase()), now);
}

void SteeredDrive::advance(BodyState & state, double rear_speed, SimTime now, double dt)
{
  const auto slipping = model_->axleSpeeds();
  const double speed = slipping ? slipping->driven : rear_speed;
  model_->advance(state, actuation_.input(speed, state.delta, now, dt), dt);
}

// Wheels slip equally on both sides, in addition to the differences in speed that come from turning.
WheelMotion SteeredDrive::wheels(const BodyState & state) const
{
  const double speed = bodyVelocity(state).x;
  WheelMotion wheels{
    speed, wheelSpeeds(speed, state.psi_dot, state.delta, parameters_.wheelbase(), track_width_, wheel_radius_)};
  if (const auto slipping = model_->axleSpeeds()) {
    std::array<double, 4> & w = wheels.speeds;
    const double front = slipping->front / wheel_radius_ - 0.5 * (w[0] + w[1]);
    const double rear = slipping->rear / wheel_radius_ - 0.5 * (w[2] + w[3]);
    wheels = {slipping->rear, {w[0] + front, w[1] + front, w[2] + rear, w[3] + rear}};
  }
  return wheels;
}
}  // namespace f1tenth_sim2d
