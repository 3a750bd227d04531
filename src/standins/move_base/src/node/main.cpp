#include <ros/ros.h>
#include <sim2d_lockstep/participant.h>
#include <workspace_support/errors.h>

#include <iostream>
#include <utility>

#include "move_base_node.h"

namespace
{
const ros::WallDuration kPoll{0.002};

void reportMissing(const move_base::MoveBaseNode & node)
{
  if (!node.ready()) {
    ROS_WARN_DELAYED_THROTTLE(5.0, "Waiting for %s", node.missing().c_str());
  }
}

void spin(move_base::MoveBaseNode & node, ros::CallbackQueue & queue)
{
  while (ros::ok()) {
    queue.callAvailable(kPoll);
    node.handleCallbacks();
    reportMissing(node);
    if (ros::Time::isValid()) {
      node.cycle(ros::Time::now());
    }
  }
}

void spinInLockstep(move_base::MoveBaseNode & node, const std::string & after)
{
  const auto predecessors = after.empty() ? std::vector<std::string>{} : std::vector<std::string>{after};
  sim2d_lockstep::Participant participant(ros::this_node::getName().substr(1), predecessors);
  bool ready = false;
  participant.actInPeriods([&](const ros::Time & stamp) {
    node.handleCallbacks();
    reportMissing(node);
    ready = ready || node.ready();
    if (ready) {
      node.cycle(stamp);
    }
    return ready;
  });
}
}  // namespace

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "move_base_node");
  // Lives as long as the node: with the last handle roscpp shuts down, and its console would stay silent after a restart.
  const ros::NodeHandle private_node("~");
  try {
    move_base::Planners planners;
    move_base::MoveBaseSetup setup = move_base::readSetup(private_node, planners);
    const bool lockstep = setup.parameters.lockstep;
    const std::string after = setup.parameters.lockstep_after;
    ros::CallbackQueue queue;
    move_base::MoveBaseNode node(std::move(setup), queue);
    if (lockstep) {
      spinInLockstep(node, after);
    } else {
      spin(node, queue);
    }
  } catch (const move_base::Error & error) {
    std::cerr << "move_base: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
