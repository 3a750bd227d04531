#pragma once

#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include "f1tenth_sim2d/publishing.h"

namespace f1tenth_sim2d
{
/// Collects transforms and publishes them in one message.
class TransformBatch : public TransformSender
{
public:
  TransformBatch(Advertiser & advertiser, const ros::NodeHandle & node)
  : publisher_(advertiser.advertise<tf2_msgs::TFMessage>(node, "/tf"))
  {
  }

  void send(const geometry_msgs::TransformStamped & transform) override { message_.transforms.push_back(transform); }

  void publish()
  {
    if (!message_.transforms.empty()) {
      if (publisher_.getNumSubscribers() > 0) {
        publisher_.publish(message_);
      }
      message_.transforms.clear();
    }
  }

private:
  ros::Publisher publisher_;
  tf2_msgs::TFMessage message_;
};
}  // namespace f1tenth_sim2d
