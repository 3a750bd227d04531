// What a plugin hears that subscribes to a topic of the simulator, in whose process it lives.
#include "node/transport/topic.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Imu.h>

#include <functional>
#include <vector>

#include "node/transport/outbox.h"

namespace f1tenth_sim2d::test
{
namespace
{
constexpr std::uint32_t kBatch = 5;
const ros::WallDuration kLong{20.0};  // only a hang takes that long

class TopicTest : public testing::Test
{
protected:
  TopicTest()
  {
    subscriber_ = node_.subscribe<sensor_msgs::Imu>("imu", 100, [this](const sensor_msgs::Imu::ConstPtr & imu) {
      heard_.push_back(imu->header.seq);
      stamps_.push_back(imu->header.stamp.sec);
    });
  }

  bool waitUntil(const std::function<bool()> & condition)
  {
    const ros::WallTime deadline = ros::WallTime::now() + kLong;
    while (!condition() && ros::WallTime::now() < deadline) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    }
    return condition();
  }

  void publishBatch(std::uint32_t first)
  {
    sensor_msgs::Imu imu;
    for (std::uint32_t i = first; i < first + kBatch; ++i) {
      imu.header.stamp.sec = 100 + i;
      publisher_.publish(imu);
    }
  }

  ros::NodeHandle node_;
  Outbox outbox_{node_};
  TopicPublisher<sensor_msgs::Imu> publisher_ =
    static_cast<Advertiser &>(outbox_).advertise<sensor_msgs::Imu>(node_, "imu");
  ros::Subscriber subscriber_;
  std::vector<std::uint32_t> heard_;
  std::vector<std::uint32_t> stamps_;
};
}  // namespace

TEST_F(TopicTest, SubscriberInTheSameProcessHearsEveryMessageOfABatch)
{
  ASSERT_TRUE(waitUntil([this] { return outbox_.subscriberCount() == 1; }));
  publishBatch(0);
  publishBatch(kBatch);
  EXPECT_TRUE(waitUntil([this] { return heard_.size() >= 2 * kBatch; }));
  EXPECT_EQ(heard_, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(stamps_, (std::vector<std::uint32_t>{100, 101, 102, 103, 104, 105, 106, 107, 108, 109}));
}

TEST_F(TopicTest, CountsOfATopicAddUpAndStayWhenItHasNoPublisherAnyMore)
{
  publishBatch(0);
  static_cast<Advertiser &>(outbox_).advertise<sensor_msgs::Imu>(node_, "imu").publish({});
  publisher_ = {};
  static_cast<Advertiser &>(outbox_).advertise<sensor_msgs::Imu>(node_, "other");
  EXPECT_EQ(outbox_.subscriberCount(), 0u);
  EXPECT_EQ(outbox_.counts().at("/imu")->published, kBatch + 1);
  EXPECT_EQ(outbox_.counts().at("/other")->published, 0u);
}
}  // namespace f1tenth_sim2d::test

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "topic_test");
  return RUN_ALL_TESTS();
}
