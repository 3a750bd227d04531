#include <ros/ros.h>
#include <sim2d_lockstep/participant.h>
#include <workspace_support/errors.h>
#include <workspace_support/lidar_inputs.h>
#include <workspace_support/warnings.h>

#include <iostream>
#include <vector>

#include "amcl_node.h"

namespace
{
const ros::WallDuration kPatience{0.1};
const ros::WallDuration kMapRetry{0.5};
const ros::TransportHints kNoDelay = ros::TransportHints().tcpNoDelay();

/// What the node hears, on one queue.
class Inputs
{
public:
  Inputs(amcl::AmclNode & amcl, ros::CallbackQueue & queue, bool use_map_topic)
  : amcl_(amcl), lidar_(queue, amcl.transforms(), [&amcl](const auto & scan) { amcl.add(scan); })
  {
    ros::NodeHandle node = workspace_support::servedBy(queue);
    subscribers_ = {node.subscribe("initialpose", 2, &Inputs::onInitialPose, this, kNoDelay)};
    if (use_map_topic) {
      subscribers_.push_back(node.subscribe("map", 1, &Inputs::onMap, this, kNoDelay));
    }
  }

  void startAfter(const ros::Time & stamp) { lidar_.startAfter(stamp); }
  bool areConnected() { return lidar_.areConnected(); }

  void handle(const ros::Time & now)
  {
    if (lidar_.jumpsBackTo(now)) {
      ROS_WARN("Time jumped back: scans and transforms from before are forgotten, the pose is not");
      amcl_.forgetInputs();
    }
    amcl_.handleScans();
  }

private:
  void onInitialPose(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr & message) { amcl_.setPose(*message); }
  void onMap(const nav_msgs::OccupancyGrid::ConstPtr & map) { amcl_.setMap(*map); }

  amcl::AmclNode & amcl_;
  workspace_support::LidarInputs lidar_;
  std::vector<ros::Subscriber> subscribers_;
};

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

void spin(Inputs & inputs, ros::CallbackQueue & queue)
{
  while (ros::ok()) {
    queue.callAvailable(kPatience);
    inputs.handle(ros::Time::now());
  }
}

void spinInLockstep(const amcl::AmclNode & amcl, Inputs & inputs, ros::CallbackQueue & queue)
{
  sim2d_lockstep::Participant participant(ros::this_node::getName().substr(1));
  bool ready = false;
  participant.actInPeriods([&](const ros::Time & stamp) {
    if (!ready) {
      inputs.startAfter(stamp);
    }
    queue.callAvailable();
    inputs.handle(stamp);
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
    Inputs inputs(amcl, queue, parameters.use_map_topic);
    if (!parameters.use_map_topic) {
      requestMap(amcl);
    }
    if (parameters.lockstep) {
      spinInLockstep(amcl, inputs, queue);
    } else {
      spin(inputs, queue);
    }
  } catch (const amcl::Error & error) {
    std::cerr << "amcl: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
