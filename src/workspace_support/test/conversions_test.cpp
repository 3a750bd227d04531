#include "workspace_support/conversions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace workspace_support
{
namespace
{
constexpr double kTolerance = 1e-12;

void expectNear(const Pose2 & found, const Pose2 & expected)
{
  EXPECT_NEAR(found.x, expected.x, kTolerance);
  EXPECT_NEAR(found.y, expected.y, kTolerance);
  EXPECT_NEAR(found.yaw, expected.yaw, kTolerance);
}

geometry_msgs::Quaternion rotation(double w, double x, double y, double z)
{
  geometry_msgs::Quaternion q;
  q.w = w;
  q.x = x;
  q.y = y;
  q.z = z;
  return q;
}

TEST(Planar, AnglesAreWithinHalfATurn)
{
  EXPECT_NEAR(normalizeAngle(7.0), 7.0 - 2.0 * M_PI, 1e-12);
  EXPECT_NEAR(normalizeAngle(-4.0), 2.0 * M_PI - 4.0, 1e-12);
  EXPECT_EQ(normalizeAngle(1.0), 1.0);
}

TEST(Geometry, APoseComposedWithItsInverseIsTheOrigin)
{
  const Pose2 pose{3.0, -2.0, 2.5};
  expectNear(compose(pose, inverse(pose)), {});
  expectNear(compose(inverse(pose), pose), {});
}

TEST(Geometry, AComposedPoseIsTurnedAndMoved)
{
  expectNear(compose({1.0, 2.0, 0.5 * M_PI}, {1.0, 0.0, 0.75 * M_PI}), {1.0, 3.0, -0.75 * M_PI});
}

TEST(Conversions, FramesLoseTheSlashOfTf1)
{
  EXPECT_EQ(withoutSlash("/robot1/odom"), "robot1/odom");
  EXPECT_EQ(withoutSlash("odom"), "odom");
  EXPECT_EQ(withoutSlash(""), "");
}

TEST(Conversions, PosesAndTransformsComeBackAsTheyWere)
{
  const Pose2 pose{3.0, -2.0, -2.5};
  expectNear(fromPose(toPose(pose)), pose);
  expectNear(fromTransform(toTransform(pose)), pose);
}

TEST(Conversions, YawOfATiltedPoseIsThatOfItsXAxisSeenFromAbove)
{
  geometry_msgs::Pose pose;
  // First rolled by 0.4, then turned by 90 deg.
  const double s = std::sqrt(0.5);
  pose.orientation = rotation(s * std::cos(0.2), s * std::sin(0.2), s * std::sin(0.2), s * std::cos(0.2));
  EXPECT_NEAR(fromPose(pose).yaw, 0.5 * M_PI, kTolerance);
}

TEST(Conversions, ALidarIsUpsideDownWhenItsZAxisPointsDown)
{
  geometry_msgs::Transform transform;
  transform.rotation = rotation(0.0, 1.0, 0.0, 0.0);
  EXPECT_TRUE(isUpsideDown(transform));
  transform.rotation = rotation(0.8, 0.0, 0.0, 0.6);
  EXPECT_FALSE(isUpsideDown(transform));
}

TEST(Conversions, BeamsOfALidarUpsideDownCountClockwise)
{
  sensor_msgs::LaserScan message;
  message.angle_min = -2.0F;
  message.angle_increment = 0.5F;
  message.range_min = 0.25F;
  message.range_max = 10.0F;
  message.ranges = {1.0F, 2.0F};
  const Scan scan = fromLaserScan(message, true);
  EXPECT_EQ(scan.angle_min, 2.0);
  EXPECT_EQ(scan.angle_increment, -0.5);
  EXPECT_EQ(scan.range_min, 0.25);
  EXPECT_EQ(scan.range_max, 10.0);
  EXPECT_EQ(scan.ranges, message.ranges);
  EXPECT_EQ(fromLaserScan(message, false).angle_min, -2.0);
}
}  // namespace
}  // namespace workspace_support
