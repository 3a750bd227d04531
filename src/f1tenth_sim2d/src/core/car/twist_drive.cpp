#include "core/car/twist_drive.h"

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>

#include "core/math/planar_pose.h"
#include "f1tenth_sim2d/ackermann.h"

namespace f1tenth_sim2d
{
namespace
{
using Kind = DriveDescription::Kind;

/// How far the point that a car turns about is ahead of the middle of its rear axle, m.
double turningPoint(Kind kind, const VehicleParameters & parameters)
{
  switch (kind) {
    case Kind::kSkidSteer:
      return 0.5 * parameters.wheelbase();  // the wheels of both axles slip alike
    case Kind::kPlanarMove:
      return parameters.l_r;  // Gazebo sets the velocity of the centre of mass
    default:
      return 0.0;
  }
}
}  // namespace

TwistCommand twistFromCommand(const DriveCommand & command, double wheelbase)
{
  // A wheel across the car would roll on the spot.
  constexpr double kSteeringMax = 1.5;  // rad
  const maths::SineCosine steering = maths::sineCosine(std::clamp(command.steering_angle, -kSteeringMax, kSteeringMax));
  return {{command.speed, 0.0}, command.speed * steering.sine / steering.cosine / wheelbase};
}

bool TwistDrive::drives(const CarDescription & car)
{
  const bool steers = std::any_of(
    car.mechanism.begin(), car.mechanism.end(), [](const JointDescription & joint) { return joint.steers(); });
  return car.drive && car.drive->kind != Kind::kAckermann && !steers;
}

TwistDrive::TwistDrive(const CarDescription & car, const VehicleParameters & parameters)
: parameters_(parameters),
  track_width_(car.track_width),
  wheel_radius_(car.wheel_radius),
  goes_sideways_(car.drive->kind == Kind::kPlanarMove),
  centre_ahead_(parameters.l_r - turningPoint(car.drive->kind, parameters)),
  acceleration_max_(std::min(parameters.a_max, car.drive->acceleration_max)),
  angular_acceleration_max_(acceleration_max_ / (0.5 * car.track_width)),
  commands_(parameters)
{
}

void TwistDrive::command(const DriveCommand & command, SimTime now)
{
  commands_.give(limited(twistFromCommand(command, parameters_.wheelbase())), now);
}

void TwistDrive::command(const TwistCommand & command, SimTime now)
{
  commands_.give(limited(command), now);
}

void TwistDrive::restart()
{
  commands_ = DelayedCommand<TwistCommand>(parameters_);
}

TwistCommand TwistDrive::limited(const TwistCommand & command) const
{
  const double ahead = std::clamp(command.velocity.x, parameters_.v_min, parameters_.v_max);
  const double aside = std::clamp(command.velocity.y, -parameters_.v_max, parameters_.v_max);
  return {{ahead, goes_sideways_ ? aside : 0.0}, command.yaw_rate};
}

/// As near to the wanted velocity as a step of dt seconds allows.
Vec2 TwistDrive::approached(const Vec2 & velocity, const Vec2 & wanted, double dt) const
{
  const Vec2 change{wanted.x - velocity.x, wanted.y - velocity.y};
  const double most = acceleration_max_ * dt;
  const double size = length(change);
  const double share = size > most ? most / size : 1.0;
  return {velocity.x + share * change.x, velocity.y + share * change.y};
}

void TwistDrive::advance(BodyState & state, double /*rear_speed*/, SimTime now, double dt)
{
  commands_.takeEffect(now);
  const TwistCommand wanted = commands_.isOld(now) ? TwistCommand{} : commands_.active();
  const BodyState before = state;
  const Vec2 free = bodyVelocity(before);
  const Vec2 velocity = approached({free.x, free.y - centre_ahead_ * before.psi_dot}, wanted.velocity, dt);
  const double most = angular_acceleration_max_ * dt;
  state.psi_dot += std::clamp(wanted.yaw_rate - before.psi_dot, -most, most);
  setBodyVelocity(state, {velocity.x, velocity.y + centre_ahead_ * state.psi_dot});
  moveOn(state, before, dt);
}

WheelMotion TwistDrive::wheels(const BodyState & state) const
{
  const double speed = bodyVelocity(state).x;
  return {speed, wheelSpeeds(speed, state.psi_dot, state.delta, parameters_.wheelbase(), track_width_, wheel_radius_)};
}
}  // namespace f1tenth_sim2d
