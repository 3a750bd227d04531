#pragma once

#include <gazebo_msgs/DeleteModel.h>
#include <gazebo_msgs/GetLinkState.h>
#include <gazebo_msgs/GetModelProperties.h>
#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/SetModelState.h>
#include <gazebo_msgs/SpawnModel.h>
#include <ros/node_handle.h>

#include <vector>

#include "node/cars/fleet.h"
#include "node/gazebo_api/gazebo_entities.h"

namespace f1tenth_sim2d
{
/// The services of gazebo_ros about cars and models.
class GazeboModels
{
public:
  /// @param node  its callback queue must be served by the simulation's thread
  GazeboModels(ros::NodeHandle & node, Simulation & simulation, Fleet & fleet);

private:
  bool spawn(gazebo_msgs::SpawnModel::Request & request, gazebo_msgs::SpawnModel::Response & response);
  bool remove(gazebo_msgs::DeleteModel::Request & request, gazebo_msgs::DeleteModel::Response & response);
  bool getState(gazebo_msgs::GetModelState::Request & request, gazebo_msgs::GetModelState::Response & response);
  bool setState(gazebo_msgs::SetModelState::Request & request, gazebo_msgs::SetModelState::Response & response);
  bool getLinkState(gazebo_msgs::GetLinkState::Request & request, gazebo_msgs::GetLinkState::Response & response);
  bool getProperties(
    gazebo_msgs::GetModelProperties::Request & request, gazebo_msgs::GetModelProperties::Response & response);
  void put(const gazebo_msgs::ModelState & wanted, const Entity & entity, const Entity & reference);

  Simulation & simulation_;
  Fleet & fleet_;
  std::vector<ros::ServiceServer> servers_;
  ros::Subscriber state_subscriber_;
};
}  // namespace f1tenth_sim2d
