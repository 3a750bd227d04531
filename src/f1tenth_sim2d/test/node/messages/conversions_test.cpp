#include "node/messages/conversions.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace f1tenth_sim2d;

TEST(Conversions, TwistToAnAckermannDriveHoldsASteeringAngle)
{
  DriveDescription drive;
  drive.steering_max = 0.4;
  drive.speed_max = 3.0;
  const auto command = [&drive](double speed, double angle) {
    return toDriveCommand(toTwist({speed, 0}, angle), drive);
  };
  EXPECT_EQ(command(2.0, 0.3).speed, 2.0);
  EXPECT_EQ(command(2.0, 0.3).steering_angle, 0.3);
  EXPECT_EQ(command(0.0, 0.3).steering_angle, 0.3);
  EXPECT_EQ(command(-2.0, 0.3).steering_angle, -0.3) << "as Gazebo's plugin does";
  EXPECT_EQ(command(9.0, -9.0).speed, 3.0);
  EXPECT_EQ(command(9.0, -9.0).steering_angle, -0.4);
  EXPECT_TRUE(std::isnan(command(2.0, std::nan("")).steering_angle)) << "so that it is refused";
  EXPECT_TRUE(std::isinf(command(HUGE_VAL, 0.3).speed)) << "so that it is refused";
}

TEST(Conversions, ContactForceIsSharedByItsPoints)
{
  Contact contact;
  contact.own_collision = "robot1::base_footprint::bumper_front_collision";
  contact.other_collision = "walls::east::collision";
  contact.positions = {{1.0, 2.0}, {1.0, 2.5}};
  contact.normals = {{-1.0, 0.0}, {-1.0, 0.0}};
  contact.depths = {0.01, 0.02};
  contact.force = {-8.0, 2.0};
  contact.torque = 3.0;
  const auto state = toContactState(contact);
  EXPECT_EQ(state.info, "robot1::base_footprint::bumper_front_collision touches walls::east::collision");
  EXPECT_EQ(state.collision1_name, contact.own_collision);
  EXPECT_EQ(state.collision2_name, contact.other_collision);
  EXPECT_EQ(state.total_wrench.force.x, -8.0);
  EXPECT_EQ(state.total_wrench.torque.z, 3.0);
  ASSERT_EQ(state.wrenches.size(), 2u);
  EXPECT_EQ(state.wrenches[1].force.x, -4.0);
  EXPECT_EQ(state.wrenches[1].force.y, 1.0);
  EXPECT_EQ(state.wrenches[1].torque.z, 1.5);
  ASSERT_EQ(state.contact_positions.size(), 2u);
  EXPECT_EQ(state.contact_positions[1].y, 2.5);
  ASSERT_EQ(state.contact_normals.size(), 2u);
  EXPECT_EQ(state.contact_normals[0].x, -1.0);
  EXPECT_EQ(state.depths, contact.depths);
}
