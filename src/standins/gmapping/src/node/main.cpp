#include <ros/ros.h>
#include <sim2d_lockstep/participant.h>
#include <workspace_support/errors.h>
#include <workspace_support/lidar_inputs.h>

#include <iostream>

#include "slam_node.h"

namespace
{
using workspace_support::LidarInputs;

const ros::WallDuration kPatience{0.1};

void handle(gmapping::SlamNode & slam, LidarInputs & inputs, const ros::Time & now)
{
  if (inputs.jumpsBackTo(now)) {
    ROS_WARN("Time jumped back: scans and transforms from before are forgotten, the map is not");
    slam.forgetInputs();
  }
  slam.handleScans();
  slam.sayWhatIsMissing();
}

void spin(gmapping::SlamNode & slam, LidarInputs & inputs, ros::CallbackQueue & queue, double period)
{
  // On a thread of its own: processing a scan may take longer than the period.
  ros::CallbackQueue timer_queue;
  ros::NodeHandle timer_node;
  timer_node.setCallbackQueue(&timer_queue);
  const auto broadcast = [&](const ros::TimerEvent &) { slam.broadcast(ros::Time::now()); };
  const ros::Timer timer = period > 0.0 ? timer_node.createTimer(ros::Duration(period), broadcast) : ros::Timer();
  ros::AsyncSpinner spinner(1, &timer_queue);
  spinner.start();
  while (ros::ok()) {
    queue.callAvailable(kPatience);
    handle(slam, inputs, ros::Time::now());
    slam.leaveOutTheOldest();
  }
  spinner.stop();
}

void spinInLockstep(gmapping::SlamNode & slam, LidarInputs & inputs, ros::CallbackQueue & queue)
{
  sim2d_lockstep::Participant participant(ros::this_node::getName().substr(1));
  bool ready = false;
  participant.actInPeriods([&](const ros::Time & stamp) {
    if (!ready) {
      inputs.startAfter(stamp);
    }
    queue.callAvailable();
    handle(slam, inputs, stamp);
    ready = ready || (inputs.areConnected() && slam.knowsOdometry());
    if (ready) {
      slam.broadcast(stamp);
    }
    return ready;
  });
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
    LidarInputs inputs(queue, slam.transforms(), [&slam](const auto & scan) { slam.add(scan); });
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
