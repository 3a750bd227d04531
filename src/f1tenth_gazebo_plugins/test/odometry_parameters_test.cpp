#include "../src/perfect_odometry/odometry_parameters.h"

#include <gtest/gtest.h>

#include "f1tenth_sim2d/errors.h"

using f1tenth_gazebo_plugins::OdometryParameters;
using f1tenth_gazebo_plugins::parseOdometryParameters;

namespace
{
using Tags = std::vector<std::pair<std::string, std::string>>;

OdometryParameters parse(const Tags & tags)
{
  const f1tenth_sim2d::PluginElement element{"perfect_odometry", "lib.so", "robot1: plugin[perfect_odometry]", tags};
  return parseOdometryParameters(element, {"base_footprint", "base_link", "laser"}, "base_footprint", 1000.0);
}

std::string errorOf(const Tags & tags)
{
  try {
    parse(tags);
  } catch (const f1tenth_sim2d::Error & error) {
    return error.what();
  }
  return "no error";
}

const std::string kPlace = "robot1: plugin[perfect_odometry]: ";
}  // namespace

TEST(OdometryParameters, DefaultsWithoutTags)
{
  const auto parameters = parse({});
  EXPECT_TRUE(parameters.always_on);
  EXPECT_EQ(parameters.update_rate_hz, 200.0);
  EXPECT_EQ(parameters.topic, "perfect_odom");
  EXPECT_EQ(parameters.odometry_frame, "odom");
  EXPECT_FALSE(parameters.log_level);
}

TEST(OdometryParameters, ReadsEveryTag)
{
  const auto parameters = parse(
    {{"alwaysOn", " false "},
     {"updateRate", "50.0"},
     {"odometryTopic", "truth"},
     {"poseTopic", "pose"},
     {"odometryFrame", "world"},
     {"robotBaseFrame", "base_footprint"},
     {"rosDebugLevel", "Debug"}});
  EXPECT_FALSE(parameters.always_on);
  EXPECT_EQ(parameters.update_rate_hz, 50.0);
  EXPECT_EQ(parameters.topic, "truth");
  EXPECT_EQ(parameters.pose_topic, "pose");
  EXPECT_EQ(parameters.odometry_frame, "world");
  EXPECT_EQ(parameters.log_level, ros::console::levels::Debug);
}

TEST(OdometryParameters, LogLevelNaLeavesTheLogger)
{
  EXPECT_FALSE(parse({{"rosDebugLevel", "na"}}).log_level);
}

TEST(OdometryParameters, RefusesUnknownTag)
{
  EXPECT_EQ(
    errorOf({{"updaterate", "200"}}), kPlace +
                                        "<updaterate>: unknown; allowed: alwaysOn, updateRate, odometryTopic, "
                                        "poseTopic, odometryFrame, robotBaseFrame, rosDebugLevel");
}

TEST(OdometryParameters, RefusesTagGivenTwice)
{
  EXPECT_EQ(
    errorOf({{"updateRate", "200"}, {"updateRate", "100"}}), kPlace + "<updateRate>: found twice, expected once");
}

TEST(OdometryParameters, RefusesRatesThatCannotBe)
{
  for (const char * text : {"0", "-1", "nan", "inf", "1001", "fast", "200 Hz", ""}) {
    EXPECT_EQ(
      errorOf({{"updateRate", text}}),
      kPlace + "<updateRate>: found \"" + text +
        "\", expected a number of Hz > 0 and at most 1000, the rate of the physics steps");
  }
}

TEST(OdometryParameters, RefusesUnknownBaseFrameAndListsTheLinks)
{
  EXPECT_EQ(
    errorOf({{"robotBaseFrame", "base"}}),
    kPlace +
      "<robotBaseFrame>: found \"base\", expected a link of the robot description: base_footprint, base_link, laser");
}

TEST(OdometryParameters, RefusesBaseFrameThatHasAParent)
{
  EXPECT_EQ(
    errorOf({{"robotBaseFrame", "laser"}}), kPlace +
                                              "<robotBaseFrame>: found \"laser\", expected base_footprint, the link "
                                              "that stands for the car: every other one gets "
                                              "its transform from the robot description");
}

TEST(OdometryParameters, RefusesFlagsNamesAndLevels)
{
  EXPECT_EQ(errorOf({{"alwaysOn", "yes"}}), kPlace + "<alwaysOn>: found \"yes\", expected true or false");
  EXPECT_EQ(errorOf({{"odometryTopic", " "}}), kPlace + "<odometryTopic>: found \"\", expected a name without spaces");
  EXPECT_EQ(
    errorOf({{"odometryFrame", "my odom"}}),
    kPlace + "<odometryFrame>: found \"my odom\", expected a name without spaces");
  EXPECT_EQ(
    errorOf({{"rosDebugLevel", "loud"}}),
    kPlace + "<rosDebugLevel>: found \"loud\", expected one of Debug, Info, Warn, Error, Fatal, na");
}

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
