#include "core/car/joint_state.h"

#include <array>

#include "f1tenth_sim2d/ackermann.h"

namespace f1tenth_sim2d
{
namespace
{
using Role = JointDescription::Role;

double steeringAngle(Role role, const Simulation & simulation, CarId car)
{
  const double angle = simulation.state(car).steering_angle;
  if (role == Role::kSteeringMiddle) {
    return angle;
  }
  const SteeringAngles steering =
    ackermannSteering(angle, simulation.parameters(car).wheelbase(), simulation.car(car).track_width);
  return role == Role::kSteeringLeft ? steering.left : steering.right;
}

/// A wheel's value among those of the four wheels; for a wheel in the middle the mean of those beside it.
double ofWheel(Role role, const std::array<double, 4> & wheels)
{
  switch (role) {
    case Role::kWheelFrontMiddle:
      return 0.5 * (wheels[0] + wheels[1]);
    case Role::kWheelRearMiddle:
      return 0.5 * (wheels[2] + wheels[3]);
    default:
      return wheels.at(static_cast<std::size_t>(role));
  }
}
}  // namespace

JointState jointState(const JointDescription & joint, const Simulation & simulation, CarId car)
{
  if (joint.steers()) {
    return {joint.direction * steeringAngle(joint.role, simulation, car), 0.0};
  }
  const CarState & state = simulation.state(car);
  return {
    joint.direction * ofWheel(joint.role, state.wheel_angles),
    joint.direction * ofWheel(joint.role, state.wheel_speeds)};
}
}  // namespace f1tenth_sim2d
