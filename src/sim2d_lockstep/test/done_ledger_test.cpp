#include "sim2d_lockstep/done_ledger.h"

#include <gtest/gtest.h>

#include "sim2d_lockstep/participant.h"

using sim2d_lockstep::DoneLedger;
using sim2d_lockstep::kLeft;

TEST(DoneLedger, WithoutNamesIsAlwaysDone)
{
  EXPECT_TRUE(DoneLedger({}).allDone(ros::Time(1.0)));
}

TEST(DoneLedger, IsDoneWhenEveryNameHasReachedTheStamp)
{
  DoneLedger ledger({"a", "b"});
  ledger.note("a", ros::Time(1.0));
  EXPECT_FALSE(ledger.allDone(ros::Time(1.0)));
  ledger.note("b", ros::Time(2.0));
  EXPECT_TRUE(ledger.allDone(ros::Time(1.0)));
  EXPECT_FALSE(ledger.allDone(ros::Time(1.5)));
}

TEST(DoneLedger, IgnoresOtherNames)
{
  DoneLedger ledger({"a"});
  ledger.note("b", ros::Time(1.0));
  EXPECT_FALSE(ledger.allDone(ros::Time(1.0)));
}

TEST(DoneLedger, DoesNotWaitForWhoHasLeft)
{
  DoneLedger ledger({"a"});
  ledger.note("a", kLeft);
  EXPECT_TRUE(ledger.allDone(ros::Time(1e9)));
}

TEST(DoneLedger, NamesWhoIsMissingInTheOrderGiven)
{
  DoneLedger ledger({"c", "a", "b"});
  ledger.note("a", ros::Time(1.0));
  EXPECT_EQ(ledger.missing(ros::Time(1.0)), (std::vector<std::string>{"c", "b"}));
  EXPECT_EQ(ledger.missing(ros::Time(1.5)), (std::vector<std::string>{"c", "a", "b"}));
}

TEST(DoneLedger, StartAgainForgetsTheOldRunOnly)
{
  DoneLedger ledger({"old", "new", "left"});
  ledger.note("old", ros::Time(7.0));
  ledger.note("new", ros::Time(1.0));
  ledger.note("left", kLeft);
  ledger.startAgain(ros::Time(1.0));
  EXPECT_FALSE(ledger.allDone(ros::Time(1.0)));
  ledger.note("old", ros::Time(1.0));
  EXPECT_TRUE(ledger.allDone(ros::Time(1.0)));
}

TEST(DoneLedger, AnswerToTheOldRunThatComesLateDoesNotCount)
{
  DoneLedger ledger({"a"});
  ledger.startAgain(ros::Time(1.0));
  ledger.note("a", ros::Time(7.0));
  EXPECT_FALSE(ledger.allDone(ros::Time(1.0)));
  ledger.note("a", ros::Time(1.0));
  EXPECT_TRUE(ledger.allDone(ros::Time(1.0)));
  EXPECT_FALSE(ledger.allDone(ros::Time(2.0)));
}

TEST(DoneLedger, WhoActsMoreSeldomSaysSoTwiceInTheFirstPeriod)
{
  DoneLedger ledger({"a"});
  ledger.startAgain(ros::Time(1.0));
  ledger.note("a", ros::Time(7.0));
  ledger.note("a", ros::Time(4.0));
  EXPECT_FALSE(ledger.allDone(ros::Time(1.0)));
  ledger.note("a", ros::Time(4.0));
  EXPECT_TRUE(ledger.allDone(ros::Time(4.0)));
  ledger.note("a", ros::Time(9.0));
  EXPECT_TRUE(ledger.allDone(ros::Time(9.0)));
}

TEST(DoneLedger, WhoHasAnsweredTheFirstPeriodBeforeItWasNoticedIsBelievedAtOnce)
{
  DoneLedger ledger({"a"});
  ledger.note("a", ros::Time(1.0));
  ledger.startAgain(ros::Time(1.0));
  ledger.note("a", ros::Time(4.0));
  EXPECT_TRUE(ledger.allDone(ros::Time(4.0)));
}

TEST(DoneLedger, FarewellCountsInTheFirstPeriodAtOnce)
{
  DoneLedger ledger({"a"});
  ledger.startAgain(ros::Time(1.0));
  ledger.note("a", kLeft);
  EXPECT_TRUE(ledger.allDone(ros::Time(1e9)));
}

TEST(IsParticipant, AnswersOnlyForItselfWithItsSecondHalf)
{
  using sim2d_lockstep::isParticipant;
  EXPECT_TRUE(isParticipant("/robot1/race_mgr", "robot1/race_mgr"));
  EXPECT_TRUE(isParticipant("/robot1/race_mgr_roscpp", "robot1/race_mgr"));
  for (const auto * caller : {"robot1/race_mgr", "/race_mgr", "/robot2/race_mgr", "/robot1/race_mgr_roscpp_1", ""}) {
    EXPECT_FALSE(isParticipant(caller, "robot1/race_mgr")) << caller;
  }
}

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
