#include <gtest/gtest.h>
#include <ros/init.h>

#include "workspace_support/errors.h"
#include "workspace_support/parameter_reader.h"

namespace workspace_support
{
namespace
{
TEST(NodeParameters, AreThoseInTheNamespaceOfANode)
{
  ParameterReader reader(ros::NodeHandle("~"));
  double speed = 0.0;
  EXPECT_TRUE(reader.read("speed", speed));
  EXPECT_EQ(speed, 2.5);
  EXPECT_EQ(reader.unused(), (std::vector<std::string>{"frame", "nobody/asks"}));
}

TEST(NodeParameters, AreNamedInFull)
{
  ParameterReader reader(ros::NodeHandle("~"));
  double value = 0.0;
  try {
    reader.read("frame", value);
    FAIL() << "not refused";
  } catch (const OptionError & error) {
    EXPECT_STREQ(error.what(), "parameter /node_test/frame: found \"odom\", must be a finite number");
  }
}

TEST(NodeParameters, OfANamespaceWithoutAnyAreNone)
{
  ParameterReader reader(ros::NodeHandle("/nobody/is/here"));
  EXPECT_TRUE(reader.keys().empty());
}
}  // namespace
}  // namespace workspace_support

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "node_test");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
