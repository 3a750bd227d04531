#pragma once

#include <gazebo_msgs/GetPhysicsProperties.h>
#include <gazebo_msgs/GetWorldProperties.h>
#include <gazebo_msgs/SetPhysicsProperties.h>
#include <ros/node_handle.h>
#include <std_srvs/Empty.h>

#include <functional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "node/time/time_keeper.h"
#include "node/world/intervention_log.h"

namespace f1tenth_sim2d
{
/// The services of gazebo_ros about the world and its time.
class GazeboWorld
{
public:
  /// What a service asks of the node.
  struct Actions
  {
    std::function<void()> restart;      ///< back to time 0, as if built anew
    std::function<void()> reset_poses;  ///< cars and models back to where they started
  };

  /// @param node           its callback queue must be served by the simulation's thread
  /// @param interventions  told of everything that changes the world or its time
  GazeboWorld(
    ros::NodeHandle & node, const Simulation & simulation, TimeControl & control, Actions actions,
    InterventionLog & interventions);

private:
  using GetPhysics = gazebo_msgs::GetPhysicsProperties;
  using SetPhysics = gazebo_msgs::SetPhysicsProperties;
  using GetWorld = gazebo_msgs::GetWorldProperties;
  bool getWorld(GetWorld::Request & request, GetWorld::Response & response);
  bool getPhysics(GetPhysics::Request & request, GetPhysics::Response & response);
  bool setPhysics(ros::ServiceEvent<SetPhysics::Request, SetPhysics::Response> & event);
  void serveEmpty(ros::NodeHandle & node, const std::string & name, const std::function<void()> & action);
  double timeStepSec() const { return static_cast<double>(simulation_.stepLength()) * 1e-9; }

  const Simulation & simulation_;
  TimeControl & control_;
  const Actions actions_;
  InterventionLog & interventions_;
  std::vector<ros::ServiceServer> servers_;
};
}  // namespace f1tenth_sim2d
