// Subscribes to everything that the simulator publishes about one car, and counts. When it is connected, it lets the
// car circle, sets the paused simulator going and prints "going". When asked to end (SIGINT), it pauses the simulator,
// prints "paused", waits until the simulator has ended and prints {"wall_seconds": s, "received": {"topic": messages,
// ...}, "missing": {"topic": messages, ...}}; missing are those that header.seq has skipped.
//   listener NAMESPACE
#include <gazebo_msgs/ContactsState.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/Imu.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Empty.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <list>
#include <map>
#include <string>

namespace
{
volatile std::sig_atomic_t end_requested = 0;

class Listener
{
public:
  explicit Listener(const std::string & name_space)
  : node_(name_space), command_(node_.advertise<geometry_msgs::Twist>("cmd_vel", 1))
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

  /// Makes the car circle, sets the paused simulator going and prints so.
  void go()
  {
    geometry_msgs::Twist circle;
    circle.linear.x = 1.0;
    circle.angular.z = 1.0 / 0.75;
    command_.publish(circle);
    call("/gazebo/unpause_physics");
    start_ = ros::WallTime::now();
    say("going");
  }

  void stop()
  {
    call("/gazebo/pause_physics");
    wall_sec_ = (ros::WallTime::now() - start_).toSec();
    say("paused");
  }

  bool isConnected() const
  {
    return command_.getNumSubscribers() > 0 && std::all_of(subscribers_.begin(), subscribers_.end(), &isHeard);
  }

  bool isDeserted() const { return std::none_of(subscribers_.begin(), subscribers_.end(), &isHeard); }

  void print() const
  {
    std::printf("{\"wall_seconds\": %.6f", wall_sec_);
    print("received", &Count::received);
    print("missing", &Count::missing);
    std::printf("}\n");
  }

private:
  struct Count
  {
    std::uint64_t received{0};
    std::uint64_t missing{0};
    std::uint32_t next{0};  // number of the message that comes next
  };

  void print(const char * title, std::uint64_t Count::*number) const
  {
    std::printf(", \"%s\": ", title);
    const char * separator = "{";
    for (const auto & [topic, count] : counts_) {
      std::printf("%s\"%s\": %llu", separator, topic.c_str(), static_cast<unsigned long long>(count.*number));
      separator = ", ";
    }
    std::printf("}");
  }

  template <class Message>
  static void note(const Message & message, Count & count)
  {
    ++count.received;
    if (const std_msgs::Header * header = ros::message_traits::header(message)) {
      count.missing += header->seq - count.next;
      count.next = header->seq + 1;
    }
  }

  static bool isHeard(const ros::Subscriber & subscriber) { return subscriber.getNumPublishers() > 0; }

  static void say(const char * what)
  {
    std::printf("%s\n", what);
    std::fflush(stdout);
  }

  static void call(const char * service)
  {
    std_srvs::Empty nothing;
    if (!ros::service::call(service, nothing)) {
      std::fprintf(stderr, "listener: no service %s\n", service);
      std::exit(1);
    }
  }

  template <class Message>
  void listen(const std::string & topic)
  {
    Count & count = counts_[node_.resolveName(topic)];
    subscribers_.push_back(node_.subscribe<Message>(
      topic, 0, [&count](const typename Message::ConstPtr & message) { note(*message, count); }));
  }

  ros::NodeHandle node_;
  ros::Publisher command_;
  std::map<std::string, Count> counts_;
  std::list<ros::Subscriber> subscribers_;
  ros::WallTime start_;
  double wall_sec_{0.0};
};

void spinUntil(const Listener & listener, bool (*done)(const Listener &))
{
  while (ros::ok() && !done(listener)) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "listener", ros::init_options::NoSigintHandler);
  std::signal(SIGINT, [](int) { end_requested = 1; });
  Listener listener(argc > 1 ? argv[1] : "robot1");
  spinUntil(listener, [](const Listener & each) { return each.isConnected() || end_requested; });
  listener.go();
  spinUntil(listener, [](const Listener &) { return end_requested != 0; });
  listener.stop();
  // At its end the simulator finishes its period.
  spinUntil(listener, [](const Listener & each) { return each.isDeserted(); });
  listener.print();
}
