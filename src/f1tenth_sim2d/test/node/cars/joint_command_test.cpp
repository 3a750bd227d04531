#include "node/cars/controllers/joint_command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "f1tenth_sim2d/ackermann.h"

using namespace f1tenth_sim2d;

namespace
{
using Kind = JointCommand::Kind;
using Role = JointDescription::Role;

JointDescription jointOf(Role role, double direction = 1.0)
{
  JointDescription joint;
  joint.name = "joint";
  joint.role = role;
  joint.direction = direction;
  return joint;
}

CarDescription smallCar()
{
  CarDescription car;
  car.wheel_radius = 0.05;
  car.track_width = 0.2;
  return car;
}
}  // namespace

TEST(JointCommand, WheelsRollAtTheMeanOfWhatIsAsked)
{
  const auto left = jointOf(Role::kWheelRearLeft);
  const auto right = jointOf(Role::kWheelRearRight, -1.0);
  const auto command =
    driveCommand({{Kind::kVelocity, left, 30.0}, {Kind::kVelocity, right, -50.0}}, smallCar(), {}, 0.0);
  EXPECT_DOUBLE_EQ(command.speed, 2.0);
  EXPECT_EQ(command.steering_angle, 0.0);
}

TEST(JointCommand, SteeringIsTheInverseOfAckermannsGeometry)
{
  const VehicleParameters vehicle;
  const auto left = jointOf(Role::kSteeringLeft);
  const auto right = jointOf(Role::kSteeringRight, -1.0);
  const SteeringAngles angles = ackermannSteering(0.3, vehicle.wheelbase(), 0.2);
  for (const auto & commands :
       {std::vector<JointCommand>{{Kind::kPosition, left, angles.left}, {Kind::kPosition, right, -angles.right}},
        std::vector<JointCommand>{{Kind::kPosition, left, angles.left}},
        std::vector<JointCommand>{{Kind::kPosition, right, -angles.right}}}) {
    EXPECT_NEAR(driveCommand(commands, smallCar(), vehicle, 0.0).steering_angle, 0.3, 1e-12);
  }
}

TEST(JointCommand, AJointInTheMiddleSteersByItsOwnAngle)
{
  const auto middle = jointOf(Role::kSteeringMiddle, -1.0);
  EXPECT_DOUBLE_EQ(driveCommand({{Kind::kPosition, middle, -0.3}}, smallCar(), {}, 0.0).steering_angle, 0.3);
}

TEST(JointCommand, TorquesAccelerateTheMass)
{
  VehicleParameters vehicle;
  vehicle.m = 4.0;
  vehicle.speed_gain = 10.0;
  const auto wheel = jointOf(Role::kWheelRearLeft);
  const auto command =
    driveCommand({{Kind::kEffort, wheel, 0.2}, {Kind::kEffort, wheel, 0.2}}, smallCar(), vehicle, 1.5);
  // 0.4 N m over 0.05 m are 8 N, on 4 kg 2 m/s^2.
  EXPECT_DOUBLE_EQ((command.speed - 1.5) * vehicle.speed_gain, 2.0);
}

TEST(JointCommand, RefusesWhatMakesNoSense)
{
  const auto wheel = jointOf(Role::kWheelRearLeft);
  EXPECT_EQ(objectionTo({Kind::kVelocity, wheel, 1999.0}, 0.05), "");
  EXPECT_EQ(objectionTo({Kind::kVelocity, wheel, 2001.0}, 0.05), "joint: commanded 2001, allowed is -2000 to 2000");
  EXPECT_EQ(
    objectionTo({Kind::kEffort, wheel, std::numeric_limits<double>::quiet_NaN()}, 0.05),
    "joint: commanded nan, allowed is -1000 to 1000");
  EXPECT_EQ(
    objectionTo({Kind::kPosition, wheel, -std::numeric_limits<double>::infinity()}, 0.05),
    "joint: commanded -inf, allowed is -6.2832 to 6.2832");
}
