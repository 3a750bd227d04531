#include "sim2d_lockstep/participant.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Header.h>

#include <functional>
#include <future>

using sim2d_lockstep::kLeft;
using sim2d_lockstep::Participant;

namespace
{
const ros::WallDuration kSoon{0.05};
const ros::WallDuration kLong{10.0};
const ros::Time kFirst{0, 25000000};
const ros::Time kSecond{0, 50000000};
const ros::Time kThird{0, 75000000};

/// Plays the simulator and the other participants.
class ParticipantTest : public testing::Test
{
protected:
  ParticipantTest()
  {
    node_.setCallbackQueue(&queue_);
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    done_ = node_.advertise<std_msgs::Header>("/sim2d/done", 10);
    done_listener_ = node_.subscribe<std_msgs::Header>(
      "/sim2d/done", 0, [this](const std_msgs::Header::ConstPtr & message) { heard_.push_back(*message); });
  }

  void publishClock(const ros::Time & stamp)
  {
    rosgraph_msgs::Clock message;
    message.clock = stamp;
    clock_.publish(message);
  }

  void publishDone(const std::string & name, const ros::Time & stamp)
  {
    std_msgs::Header message;
    message.frame_id = name;
    message.stamp = stamp;
    done_.publish(message);
  }

  bool hear(std::size_t count)
  {
    const auto deadline = ros::WallTime::now() + kLong;
    while (heard_.size() < count && ros::WallTime::now() < deadline) {
      queue_.callAvailable(kSoon);
    }
    return heard_.size() == count;
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Publisher clock_;
  ros::Publisher done_;
  ros::Subscriber done_listener_;
  std::vector<std_msgs::Header> heard_;
};
}  // namespace

TEST_F(ParticipantTest, ReturnsNothingWhenThereIsNoPeriodInTime)
{
  Participant participant("a");
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt);
}

TEST_F(ParticipantTest, ReturnsThePeriodUntilItIsAnswered)
{
  Participant participant("a");
  publishClock(kFirst);
  EXPECT_EQ(participant.waitForPeriod(kLong), kFirst);
  EXPECT_EQ(participant.waitForPeriod(kLong), kFirst);
  participant.done(kFirst);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt);
}

TEST_F(ParticipantTest, RosTimeIsThePeriodsStamp)
{
  Participant participant("a");
  for (int period = 1; period <= 200; ++period) {
    const auto stamp = ros::Time().fromNSec(25000000ull * period);
    publishClock(stamp);
    ASSERT_EQ(participant.waitForPeriod(kLong), stamp);
    ASSERT_EQ(ros::Time::now(), stamp);
    participant.done(stamp);
  }
}

TEST_F(ParticipantTest, SaysDoneUnderItsName)
{
  Participant participant("robot1/move_base");
  participant.done(kFirst);
  ASSERT_TRUE(hear(1));
  EXPECT_EQ(heard_[0].frame_id, "robot1/move_base");
  EXPECT_EQ(heard_[0].stamp, kFirst);
}

TEST_F(ParticipantTest, IsNotAskedBeforeTheTimeThatItSays)
{
  Participant participant("a");
  publishClock(kFirst);
  ASSERT_EQ(participant.waitForPeriod(kLong), kFirst);
  participant.done(kFirst, kThird);
  ASSERT_TRUE(hear(1));
  EXPECT_LT(heard_[0].stamp, kThird);
  EXPECT_GE(heard_[0].stamp, kSecond);
  publishClock(kSecond);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt);
  publishClock(kThird);
  EXPECT_EQ(participant.waitForPeriod(kLong), kThird);
}

TEST_F(ParticipantTest, AnswersARepeatedPeriodAgain)
{
  Participant participant("a");
  publishClock(kFirst);
  ASSERT_EQ(participant.waitForPeriod(kLong), kFirst);
  participant.done(kFirst);
  publishClock(kFirst);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt);
  ASSERT_TRUE(hear(2));
  EXPECT_EQ(heard_[1].stamp, kFirst);
}

TEST_F(ParticipantTest, ActsAfterThoseItNames)
{
  Participant participant("b", {"a", "c"});
  publishClock(kFirst);
  publishDone("a", kFirst);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt);
  publishDone("c", kFirst);
  EXPECT_EQ(participant.waitForPeriod(kLong), kFirst);
}

TEST_F(ParticipantTest, DoesNotWaitForOneThatHasLeft)
{
  Participant leaver("a");
  Participant participant("b", {"a"});
  leaver.leave();
  publishClock(kFirst);
  EXPECT_EQ(participant.waitForPeriod(kLong), kFirst);
  EXPECT_EQ(leaver.waitForPeriod(kLong), std::nullopt);
  ASSERT_TRUE(hear(1));
  EXPECT_EQ(heard_[0].stamp, kLeft);
}

TEST_F(ParticipantTest, LeavesWhenTheSimulatorGoesOnWithoutIt)
{
  Participant participant("a");
  publishClock(kFirst);
  ASSERT_EQ(participant.waitForPeriod(kLong), kFirst);
  participant.done(kFirst);
  auto leaving = std::async(std::launch::async, [&participant] { participant.leave(); });
  ASSERT_TRUE(hear(2));
  EXPECT_EQ(heard_[1].stamp, kLeft);
  publishClock(kSecond);
  publishClock(kThird);
  leaving.get();
  EXPECT_EQ(heard_.size(), 2u) << "it has answered a period after its farewell";
}

TEST_F(ParticipantTest, ActsUntilItIsReadyInEachPeriodAndNoMoreWhenItHasLeft)
{
  Participant participant("a");
  std::vector<ros::Time> stamps;
  auto acting = std::async(std::launch::async, [&] {
    participant.actInPeriods([&](const ros::Time & stamp) {
      stamps.push_back(stamp);
      if (stamp == kSecond) {
        participant.leave();
      }
      return stamps.size() >= 3;
    });
  });
  publishClock(kFirst);
  ASSERT_TRUE(hear(1));
  publishClock(kSecond);
  ASSERT_TRUE(hear(2));
  publishClock(kThird);
  acting.get();
  queue_.callAvailable(kSoon);
  EXPECT_EQ(stamps, (std::vector<ros::Time>{kFirst, kFirst, kFirst, kSecond}));
  ASSERT_EQ(heard_.size(), 2u);
  EXPECT_EQ(heard_[0].stamp, kFirst);
  EXPECT_EQ(heard_[1].stamp, kLeft);
}

TEST_F(ParticipantTest, ClockThatJumpsBackStartsANewRun)
{
  Participant participant("b", {"a"});
  for (const auto & stamp : {kFirst, kSecond}) {
    publishClock(stamp);
    publishDone("a", stamp);
    ASSERT_EQ(participant.waitForPeriod(kLong), stamp);
    participant.done(stamp);
  }
  publishClock(kFirst);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt) << "a has not acted in the new run";
  publishDone("a", kFirst);
  EXPECT_EQ(participant.waitForPeriod(kLong), kFirst);
}

TEST_F(ParticipantTest, AnswerToTheOldRunDoesNotCountInTheNewOne)
{
  Participant participant("b", {"a"});
  publishClock(kThird);
  publishDone("a", kThird);
  ASSERT_EQ(participant.waitForPeriod(kLong), kThird);
  participant.done(kThird);
  publishClock(kFirst);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt);
  publishDone("a", kSecond);
  EXPECT_EQ(participant.waitForPeriod(kSoon), std::nullopt) << "that answers the run before";
  publishDone("a", kFirst);
  EXPECT_EQ(participant.waitForPeriod(kLong), kFirst);
}

TEST(Participant, RejectsNamesThatCannotBe)
{
  const auto message = [](const std::function<void()> & make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument & error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(
    message([] { Participant(""); }),
    "name of a lockstep participant: found \"\", expected a node's name without the leading slash");
  EXPECT_EQ(
    message([] { Participant("/a"); }),
    "name of a lockstep participant: found \"/a\", expected a node's name without the leading slash");
  EXPECT_EQ(message([] { Participant("a", {"a"}); }), "lockstep participant \"a\" cannot act after itself");
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "participant_test");
  testing::InitGoogleTest(&argc, argv);
  const ros::NodeHandle keeps_ros_running;
  return RUN_ALL_TESTS();
}
