#pragma once

#include <gazebo_msgs/DeleteModel.h>
#include <gazebo_msgs/GetLinkState.h>
#include <gazebo_msgs/GetModelProperties.h>
#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/SetModelState.h>
#include <gazebo_msgs/SpawnModel.h>
#include <ros/node_handle.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "node/cars/fleet.h"
#include "node/gazebo_api/gazebo_entities.h"
#include "node/world/intervention_log.h"

namespace f1tenth_sim2d
{
/// The services of gazebo_ros about cars and models.
class GazeboModels
{
public:
  /// @param node           its callback queue must be served by the simulation's thread
  /// @param interventions  told of everything that changes the world
  GazeboModels(ros::NodeHandle & node, Simulation & simulation, Fleet & fleet, InterventionLog & interventions);

private:
  void spawn(const gazebo_msgs::SpawnModel::Request & request, gazebo_msgs::SpawnModel::Response & response);
  void remove(const gazebo_msgs::DeleteModel::Request & request, gazebo_msgs::DeleteModel::Response & response);
  void getState(const gazebo_msgs::GetModelState::Request & request, gazebo_msgs::GetModelState::Response & response);
  void setState(const gazebo_msgs::SetModelState::Request & request, gazebo_msgs::SetModelState::Response & response);
  void getLinkState(const gazebo_msgs::GetLinkState::Request & request, gazebo_msgs::GetLinkState::Response & response);
  void getProperties(
    const gazebo_msgs::GetModelProperties::Request & request, gazebo_msgs::GetModelProperties::Response & response);
  Entity model(const std::string & name) const;
  void put(const gazebo_msgs::ModelState & wanted);

  Simulation & simulation_;
  Fleet & fleet_;
  InterventionLog & interventions_;
  std::map<std::string, std::uint32_t> state_requests_;  ///< get_model_state so far, by model
  std::vector<ros::ServiceServer> servers_;
  ros::Subscriber state_subscriber_;
};
}  // namespace f1tenth_sim2d
