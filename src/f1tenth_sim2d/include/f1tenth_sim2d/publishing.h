#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/advertise_options.h>
#include <ros/node_handle.h>
#include <ros/serialization.h>

#include <memory>
#include <string>
#include <utility>

/// How the simulator and its plugins publish. Unlike with a bare ros::Publisher, the simulator knows what has not
/// been sent yet, so that it can wait: nothing is lost at high speed.
namespace f1tenth_sim2d
{
/// Where the serialised messages of one topic go.
class MessageSink
{
public:
  virtual ~MessageSink() = default;
  virtual bool hasSubscribers() const = 0;
  virtual void publish(const ros::SerializedMessage & message) = 0;
};

/// Publishes messages of one type on one topic, as long as it or a copy of it exists. On the simulation's thread only.
template <class Message>
class TopicPublisher
{
public:
  TopicPublisher() = default;
  explicit TopicPublisher(std::shared_ptr<MessageSink> sink) : sink_(std::move(sink)) {}

  bool hasSubscribers() const { return sink_->hasSubscribers(); }
  void publish(const Message & message) const { sink_->publish(ros::serialization::serializeMessage(message)); }

private:
  std::shared_ptr<MessageSink> sink_;
};

/// Makes topics.
class Advertiser
{
public:
  virtual ~Advertiser() = default;

  /// @param topic  in the namespace of node, unless it is absolute
  template <class Message>
  TopicPublisher<Message> advertise(const ros::NodeHandle & node, const std::string & topic)
  {
    ros::AdvertiseOptions options;
    options.init<Message>(node.resolveName(topic), 0);
    return TopicPublisher<Message>(add(options));
  }

protected:
  /// @param options  topic and type; queue and callbacks are up to the advertiser
  virtual std::shared_ptr<MessageSink> add(const ros::AdvertiseOptions & options) = 0;
};

/// Publishes on /tf. All transforms of one simulated time leave in one message.
class TransformSender
{
public:
  virtual ~TransformSender() = default;
  virtual void send(const geometry_msgs::TransformStamped & transform) = 0;
};
}  // namespace f1tenth_sim2d
