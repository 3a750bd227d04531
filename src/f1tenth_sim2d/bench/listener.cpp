// Subscribes to everything that the simulator publishes about one car, and counts. When asked to end (SIGINT), it waits
// until nothing comes any more and prints {"topic": messages, ...} as JSON. It sets /sim2d going when it is connected.
//   listener NAMESPACE
#include <gazebo_msgs/ContactsState.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <list>
#include <map>
#include <string>

namespace
{
volatile std::sig_atomic_t end_requested = 0;

class Listener
{
public:
  explicit Listener(const std::string & name_space) : node_(name_space)
  {
    listen<rosgraph_msgs::Clock>("/clock");
    listen<tf2_msgs::TFMessage>("/tf");
    listen<sensor_msgs::LaserScan>("scan");
    listen<nav_msgs::Odometry>("perfect_odom");
    listen<nav_msgs::Odometry>("odom");
    listen<sensor_msgs::Imu>("imu");
    listen<sensor_msgs::JointState>("joint_states");
    for (const char * side : {"front", "rear", "left", "right"}) {
      listen<gazebo_msgs::ContactsState>(std::string("bumper_") + side);
    }
  }

  bool isConnected() const
  {
    for (const auto & subscriber : subscribers_) {
      if (subscriber.getNumPublishers() == 0) {
        return false;
      }
    }
    return true;
  }

  std::uint64_t total() const
  {
    std::uint64_t sum = 0;
    for (const auto & [topic, count] : counts_) {
      sum += count;
    }
    return sum;
  }

  void print() const
  {
    const char * separator = "{";
    for (const auto & [topic, count] : counts_) {
      std::printf("%s\"%s\": %llu", separator, topic.c_str(), static_cast<unsigned long long>(count));
      separator = ", ";
    }
    std::printf("}\n");
  }

private:
  template <class Message>
  void listen(const std::string & topic)
  {
    std::uint64_t & count = counts_[node_.resolveName(topic)];
    subscribers_.push_back(
      node_.subscribe<Message>(topic, 0, [&count](const typename Message::ConstPtr &) { ++count; }));
  }

  ros::NodeHandle node_;
  std::map<std::string, std::uint64_t> counts_;
  std::list<ros::Subscriber> subscribers_;
};

void spinUntil(const Listener & listener, bool (*done)(const Listener &))
{
  while (ros::ok() && !done(listener)) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
}

void receiveTheRest(const Listener & listener)
{
  const ros::WallDuration kQuiet{0.5};
  std::uint64_t before = listener.total();
  for (ros::WallTime since = ros::WallTime::now(); ros::WallTime::now() - since < kQuiet;) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    if (listener.total() != before) {
      before = listener.total();
      since = ros::WallTime::now();
    }
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "listener", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, [](int) { end_requested = 1; });
  const Listener listener(argc > 1 ? argv[1] : "robot1");
  spinUntil(listener, [](const Listener & each) { return each.isConnected() || end_requested; });
  std_srvs::Empty go;
  ros::service::waitForService("/gazebo/unpause_physics");
  ros::service::call("/gazebo/unpause_physics", go);
  spinUntil(listener, [](const Listener &) { return end_requested != 0; });
  receiveTheRest(listener);
  listener.print();
}
