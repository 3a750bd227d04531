#include "workspace_support/lidar_inputs.h"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>
#include <functional>

namespace workspace_support
{
namespace
{
constexpr int kMany = 1000;
const ros::Duration kPeriod{0.005};
const ros::WallDuration kPatience{10.0};

ros::Time stampOf(int i)
{
  return ros::Time(100.0) + kPeriod * i;
}

/// Of a car that turns all the time.
tf2_msgs::TFMessage transformOf(int i)
{
  geometry_msgs::TransformStamped transform;
  transform.header.stamp = stampOf(i);
  transform.header.frame_id = "odom";
  transform.child_frame_id = "base_footprint";
  transform.transform.translation.x = std::sin(0.1 * i);
  transform.transform.rotation.w = 1.0;
  tf2_msgs::TFMessage message;
  message.transforms.push_back(transform);
  return message;
}

void waitUntil(const std::function<bool()> & holds)
{
  const ros::WallTime end = ros::WallTime::now() + kPatience;
  while (!holds() && ros::WallTime::now() < end) {
    ros::spinOnce();
    ros::WallDuration(0.01).sleep();
  }
  ASSERT_TRUE(holds());
}

TEST(LidarInputs, KnowAllTransformsThatCameWhileTheNodeWasBusy)
{
  ros::NodeHandle node;
  ros::CallbackQueue queue;
  tf2::BufferCore transforms;
  LidarInputs inputs(queue, transforms, [](const auto &) {});
  int heard = 0;
  const boost::function<void(const tf2_msgs::TFMessage &)> count = [&heard](const auto &) { ++heard; };
  const auto witness = node.subscribe<tf2_msgs::TFMessage>("/tf", kMany, count);
  const auto publisher = node.advertise<tf2_msgs::TFMessage>("/tf", kMany);
  waitUntil([&] { return publisher.getNumSubscribers() > 0 && witness.getNumPublishers() > 0; });

  for (int i = 0; i < kMany; ++i) {
    publisher.publish(transformOf(i));
  }
  waitUntil([&] { return heard == kMany; });
  queue.callAvailable();

  for (int i = 0; i < kMany; ++i) {
    const auto known = transforms.lookupTransform("odom", "base_footprint", stampOf(i));
    ASSERT_NEAR(known.transform.translation.x, std::sin(0.1 * i), 1e-6) << "transform " << i;
  }
}
}  // namespace
}  // namespace workspace_support
