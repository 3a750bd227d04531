#pragma once

#include <ros/subscriber.h>
#include <std_msgs/Empty.h>

#include <deque>
#include <string>
#include <vector>

#include "node/cars/sensor_output.h"
#include "node/messages/image_messages.h"

namespace f1tenth_sim2d
{
/// A topic of a camera: nothing for an empty name.
template <class Message>
class CameraTopic
{
public:
  CameraTopic(const CarHandle & car, const std::string & topic, const std::string & frame)
  : publisher_(topic.empty() ? ros::Publisher() : car.advertise<Message>(topic))
  {
    message.header.frame_id = frame;
  }

  bool isWanted() const { return publisher_ && publisher_.getNumSubscribers() > 0; }
  void publish(SimTime now)
  {
    message.header.stamp = toRosTime(now);
    publisher_.publish(message);
  }
  /// If it was published before.
  void repeat() const
  {
    if (isWanted() && !message.header.stamp.isZero()) {
      publisher_.publish(message);
    }
  }

  Message message;

private:
  ros::Publisher publisher_;
};

/// The cameras of gazebo_ros. An eye draws only while somebody subscribes to a topic with pixels; all its topics have
/// the same stamp. A triggered one looks at the step after a message that asks for it, instead of at a rate.
class CameraOutput : public Output
{
public:
  CameraOutput(const CarHandle & car, const Camera & camera);

  double rate() const override { return triggers_.empty() ? camera_.mount().rate_hz : 0.0; }
  void update(SimTime now, bool anyway) override;
  void repeat() override;

private:
  struct Eye
  {
    Eye(const CarHandle & car, const Camera::Eye & given, const std::string & frame);
    bool needsPicture() const;

    const Camera::Eye & eye;
    CameraTopic<sensor_msgs::Image> image;
    CameraTopic<sensor_msgs::CompressedImage> jpeg;
    CameraTopic<sensor_msgs::CameraInfo> info;
    CameraTopic<sensor_msgs::Image> depth;
    CameraTopic<sensor_msgs::CameraInfo> depth_info;
    CameraTopic<sensor_msgs::PointCloud2> points;
    bool is_looking{false};
    Picture picture{};
  };
  void look();
  static void publishPicture(Eye & eye, SimTime now);

  const CarHandle car_;
  const Camera & camera_;
  std::deque<Eye> eyes_;
  std::vector<ros::Subscriber> triggers_;
  bool is_triggered_{false};
  bool has_warned_{false};
};
}  // namespace f1tenth_sim2d
