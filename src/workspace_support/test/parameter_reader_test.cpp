#include "workspace_support/parameter_reader.h"

#include <gtest/gtest.h>
#include <ros/init.h>

#include "workspace_support/errors.h"

namespace workspace_support
{
namespace
{
template <class Value>
std::string refusal(const std::string & name, Value value)
{
  ParameterReader reader(ros::NodeHandle("~"));
  try {
    reader.read(name, value);
  } catch (const OptionError & error) {
    return error.what();
  }
  return "not refused";
}

TEST(ParameterReader, ReadsWhatIsThere)
{
  ParameterReader reader(ros::NodeHandle("~"));
  double speed = 0.0;
  int count = 0;
  bool on = false;
  std::string frame;
  std::optional<double> limit;
  reader.read("speed", speed);
  reader.read("count", count);
  reader.read("on", on);
  reader.read("frame", frame);
  reader.read("speed", limit);
  EXPECT_EQ(speed, 2.5);
  EXPECT_EQ(count, 7);
  EXPECT_TRUE(on);
  EXPECT_EQ(frame, "odom");
  EXPECT_EQ(limit, 2.5);
}

TEST(ParameterReader, LeavesWhatIsNotThere)
{
  ParameterReader reader(ros::NodeHandle("~"));
  double value = 3.0;
  std::optional<double> limit;
  reader.read("absent", value);
  reader.read("absent", limit);
  EXPECT_EQ(value, 3.0);
  EXPECT_FALSE(limit);
}

TEST(ParameterReader, AWholeNumberIsANumber)
{
  ParameterReader reader(ros::NodeHandle("~"));
  double value = 0.0;
  reader.read("count", value);
  EXPECT_EQ(value, 7.0);
}

TEST(ParameterReader, SaysWhatWasFoundAndWhatIsAllowed)
{
  EXPECT_EQ(refusal("frame", 0.0), "/parameter_reader_test/frame: found <value>odom</value>, must be a number");
  EXPECT_EQ(refusal("frame", 0), "/parameter_reader_test/frame: found <value>odom</value>, must be a whole number");
  EXPECT_EQ(
    refusal("count", false), "/parameter_reader_test/count: found <value><i4>7</i4></value>, must be true or false");
  EXPECT_EQ(
    refusal("on", std::string()),
    "/parameter_reader_test/on: found <value><boolean>1</boolean></value>, must be a text");
}

TEST(ParameterReader, TellsWhatNobodyHasAskedFor)
{
  ParameterReader reader(ros::NodeHandle("~"));
  double value = 0.0;
  reader.read("speed", value);
  EXPECT_EQ(reader.unused(), (std::vector<std::string>{"count", "frame", "nobody/asks", "on"}));
}
}  // namespace
}  // namespace workspace_support

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "parameter_reader_test");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
