#include "node/cars/controllers/joint_command.h"

#include <workspace_support/maths/trigonometry.h>
#include <cmath>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
// As for commands of whole cars: far beyond any car of this size, but still a meaningful number.
constexpr double kSpeedMax = 100.0;    // m/s, of a wheel's tread
constexpr double kEffortMax = 1000.0;  // N m
constexpr double kAngleMax = 6.2832;   // rad

class Mean
{
public:
  void add(double value)
  {
    sum_ += value;
    ++count_;
  }
  bool isEmpty() const { return count_ == 0; }
  double value() const { return isEmpty() ? 0.0 : sum_ / count_; }

private:
  double sum_{0.0};
  int count_{0};
};

/// Angle of the single-track front wheel from that of a steering joint.
double singleTrackAngle(double angle, JointDescription::Role role, double wheelbase, double track_width)
{
  const double slope = maths::tan(angle);
  const double offset = slope * track_width / (2.0 * wheelbase);
  switch (role) {
    case JointDescription::Role::kSteeringLeft:
      return maths::atan2(slope, 1.0 + offset);
    case JointDescription::Role::kSteeringRight:
      return maths::atan2(slope, 1.0 - offset);
    default:
      return angle;
  }
}

double limitOf(const JointCommand & command, double wheel_radius)
{
  switch (command.kind) {
    case JointCommand::Kind::kVelocity:
      return kSpeedMax / wheel_radius;
    case JointCommand::Kind::kEffort:
      return kEffortMax;
    case JointCommand::Kind::kPosition:
      return kAngleMax;
  }
  return 0.0;
}
}  // namespace

DriveCommand driveCommand(
  const std::vector<JointCommand> & commands, const CarDescription & car, const VehicleParameters & vehicle,
  double speed)
{
  Mean wheel_speed;
  Mean steering;
  double force = 0.0;
  bool is_pushed = false;
  for (const JointCommand & command : commands) {
    const double value = command.value * command.joint.direction;
    if (command.kind == JointCommand::Kind::kVelocity) {
      wheel_speed.add(value * car.wheel_radius);
    } else if (command.kind == JointCommand::Kind::kEffort) {
      force += value / car.wheel_radius;
      is_pushed = true;
    } else {
      steering.add(singleTrackAngle(value, command.joint.role, vehicle.wheelbase(), car.track_width));
    }
  }
  // The car accelerates by speed_gain times the difference to the speed that is asked for.
  const double pushed_speed = is_pushed ? speed + force / vehicle.m / vehicle.speed_gain : 0.0;
  return {wheel_speed.isEmpty() ? pushed_speed : wheel_speed.value(), steering.value()};
}

std::string objectionTo(const JointCommand & command, double wheel_radius)
{
  const double limit = limitOf(command, wheel_radius);
  if (std::abs(command.value) <= limit) {
    return "";
  }
  return command.joint.name + ": commanded " + toText(command.value) + ", allowed is " + toText(-limit) + " to " +
         toText(limit);
}

}  // namespace f1tenth_sim2d
