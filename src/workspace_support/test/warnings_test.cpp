#include "workspace_support/warnings.h"

#include <gtest/gtest.h>

namespace workspace_support
{
namespace
{
TEST(ScanIsLeftOut, NamesTimeAndReason)
{
  EXPECT_EQ(scanIsLeftOut(ros::Time(1.05), "no transform"), "A scan at 1.050 s is left out: no transform");
}

TEST(RareWarning, IsSaidAtOnceAndThenEveryFiveSeconds)
{
  RareWarning warning;
  EXPECT_TRUE(warning.say("a scan is left out", ros::WallTime(1.0)));
  EXPECT_FALSE(warning.say("a scan is left out", ros::WallTime(5.9)));
  EXPECT_TRUE(warning.say("a scan is left out", ros::WallTime(6.1)));
}

TEST(WaitWarning, SpeaksOfAWaitOfFiveSecondsAndThenEveryFive)
{
  WaitWarning warning;
  EXPECT_FALSE(warning.waitFor("a map", ros::WallTime(1.0)));
  EXPECT_FALSE(warning.waitFor("a map", ros::WallTime(5.9)));
  EXPECT_TRUE(warning.waitFor("a map", ros::WallTime(6.1)));
  EXPECT_FALSE(warning.waitFor("a map", ros::WallTime(11.0)));
  EXPECT_TRUE(warning.waitFor("a map", ros::WallTime(11.2)));
}

TEST(WaitWarning, BeginsAnewWhenSomethingHasCome)
{
  WaitWarning warning;
  warning.waitFor("a map", ros::WallTime(1.0));
  EXPECT_FALSE(warning.waitFor("scans", ros::WallTime(6.1)));
  warning.reset();
  EXPECT_FALSE(warning.waitFor("scans", ros::WallTime(11.2)));
  EXPECT_FALSE(warning.waitFor("", ros::WallTime(16.3)));
  EXPECT_FALSE(warning.waitFor("", ros::WallTime(21.4)));
}
}  // namespace
}  // namespace workspace_support
