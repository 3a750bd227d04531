#include <ros/ros.h>
#include <sim2d_lockstep/participant.h>
#include <tf2_ros/transform_listener.h>

#include <iostream>
#include <optional>

#include "gmapping/errors.h"
#include "slam_node.h"

namespace
{
const ros::WallDuration kPatience{0.1};
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();

/// What the node hears, on one queue.
class Inputs
{
public:
  Inputs(gmapping::SlamNode & slam, ros::CallbackQueue & queue)
  : slam_(slam), node_(onQueue(queue)), listener_(slam.transforms(), node_, false, kNoDelay)
  {
    // Without a limit: what is waiting in lockstep must not be lost, and scans are left out only for want of time.
    subscriber_ = node_.subscribe("scan", 0, &gmapping::SlamNode::add, &slam, kNoDelay);
  }

  void handle(const ros::Time & now)
  {
    if (now_ && now < *now_) {
      ROS_WARN("Time jumped back: scans and transforms from before are forgotten, the map is not");
      slam_.forgetInputs();
    }
    now_ = now;
    slam_.handleScans();
  }

private:
  static ros::NodeHandle onQueue(ros::CallbackQueue & queue)
  {
    ros::NodeHandle node;
    node.setCallbackQueue(&queue);
    return node;
  }

  gmapping::SlamNode & slam_;
  ros::NodeHandle node_;
  tf2_ros::TransformListener listener_;
  ros::Subscriber subscriber_;
  std::optional<ros::Time> now_;
};

void spin(gmapping::SlamNode & slam, Inputs & inputs, ros::CallbackQueue & queue, double period)
{
  // On a thread of its own: taking a scan in may last longer than the period.
  ros::CallbackQueue timer_queue;
  ros::NodeHandle timer_node;
  timer_node.setCallbackQueue(&timer_queue);
  const auto broadcast = [&](const ros::TimerEvent &) { slam.broadcast(ros::Time::now()); };
  const ros::Timer timer = period > 0.0 ? timer_node.createTimer(ros::Duration(period), broadcast) : ros::Timer();
  ros::AsyncSpinner spinner(1, &timer_queue);
  spinner.start();
  while (ros::ok()) {
    queue.callAvailable(kPatience);
    inputs.handle(ros::Time::now());
  }
  spinner.stop();
}

void spinInLockstep(gmapping::SlamNode & slam, Inputs & inputs, ros::CallbackQueue & queue)
{
  sim2d_lockstep::Participant participant(ros::this_node::getName().substr(1));
  while (ros::ok()) {
    const auto stamp = participant.waitForPeriod(kPatience);
    if (!stamp) {
      continue;
    }
    queue.callAvailable();
    inputs.handle(*stamp);
    slam.broadcast(*stamp);
    participant.done(*stamp);
  }
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "slam_gmapping");
  // Lives as long as the node: with the last handle roscpp shuts down.
  const ros::NodeHandle private_node("~");
  try {
    const gmapping::NodeParameters parameters = gmapping::readParameters(private_node);
    ros::CallbackQueue queue;
    gmapping::SlamNode slam(parameters, queue);
    Inputs inputs(slam, queue);
    if (parameters.lockstep) {
      spinInLockstep(slam, inputs, queue);
    } else {
      spin(slam, inputs, queue, parameters.transform_publish_period);
    }
  } catch (const gmapping::Error & error) {
    std::cerr << "slam_gmapping: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
