#include <ros/ros.h>
#include <sim2d_lockstep/participant.h>
#include <workspace_support/errors.h>
#include <workspace_support/lidar_inputs.h>
#include <workspace_support/warnings.h>

#include <iostream>

#include "amcl_node.h"

namespace
{
using workspace_support::LidarInputs;

const ros::WallDuration kPatience{0.1};
const ros::WallDuration kMapRetry{0.5};

void handle(amcl::AmclNode & amcl, LidarInputs & inputs, const ros::Time & now)
{
  if (inputs.jumpsBackTo(now)) {
    ROS_WARN("Time jumped back: scans and transforms from before are forgotten, the pose is not");
    amcl.forgetInputs();
  }
  amcl.handleScans();
}

void requestMap(amcl::AmclNode & amcl)
{
  nav_msgs::GetMap map;
  workspace_support::WaitWarning warning;
  while (ros::ok() && !ros::service::call("static_map", map)) {
    warning.waitFor("an answer from the service " + ros::names::resolve("static_map"));
    kMapRetry.sleep();
  }
  if (ros::ok()) {
    amcl.setMap(map.response.map);
  }
}

void spin(amcl::AmclNode & amcl, LidarInputs & inputs, ros::CallbackQueue & queue)
{
  while (ros::ok()) {
    queue.callAvailable(kPatience);
    handle(amcl, inputs, ros::Time::now());
  }
}

void spinInLockstep(amcl::AmclNode & amcl, LidarInputs & inputs, ros::CallbackQueue & queue)
{
  sim2d_lockstep::Participant participant(ros::this_node::getName().substr(1));
  bool ready = false;
  participant.actInPeriods([&](const ros::Time & stamp) {
    if (!ready) {
      inputs.startAfter(stamp);
    }
    queue.callAvailable();
    handle(amcl, inputs, stamp);
    ready = ready || (inputs.areConnected() && amcl.ready());
    return ready;
  });
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "amcl");
  // Lives as long as the node: with the last handle roscpp shuts down.
  const ros::NodeHandle private_node("~");
  try {
    const amcl::NodeParameters parameters = amcl::readParameters(private_node);
    ros::CallbackQueue queue;
    amcl::AmclNode amcl(parameters, queue);
    LidarInputs inputs(queue, amcl.transforms(), [&amcl](const auto & scan) { amcl.add(scan); });
    if (!parameters.use_map_topic) {
      requestMap(amcl);
    }
    if (parameters.lockstep) {
      spinInLockstep(amcl, inputs, queue);
    } else {
      spin(amcl, inputs, queue);
    }
  } catch (const amcl::Error & error) {
    std::cerr << "amcl: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
