#pragma once

#include <gazebo_msgs/GetModelState.h>
#include <gazebo_msgs/ModelStates.h>
#include <ros/node_handle.h>
#include <std_srvs/Empty.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output.h"
#include "time_keeper.h"

namespace f1tenth_sim2d
{
/// A model of the world or a car, as gazebo_ros sees it: in the world's frame.
struct Entity
{
  std::string name;
  Pose2 pose;
  Vec2 velocity;         ///< m/s, world; 0 for what is not a car
  double yaw_rate{0.0};  ///< rad/s; 0 for what is not a car
};

/// All of them, cars last.
std::vector<Entity> entities(const Simulation & simulation);

/// `/gazebo/model_states`.
class ModelStatesOutput : public MessageOutput<gazebo_msgs::ModelStates>
{
public:
  ModelStatesOutput(Advertiser & advertiser, const ros::NodeHandle & node, const Simulation & simulation);

private:
  void fill(gazebo_msgs::ModelStates & message, SimTime now) override;

  const Simulation & simulation_;
};

/// The services of gazebo_ros that tests and launch files use, as far as the simulator has what they need.
class GazeboServices
{
public:
  /// @param node     its callback queue must be served by the simulation's thread
  /// @param restart  called for reset_simulation
  GazeboServices(
    ros::NodeHandle & node, const Simulation & simulation, TimeControl & control, std::function<void()> restart);

private:
  using Empty = std_srvs::Empty;
  bool setPaused(bool paused);
  bool getModelState(gazebo_msgs::GetModelState::Request & request, gazebo_msgs::GetModelState::Response & response);

  const Simulation & simulation_;
  TimeControl & control_;
  std::vector<ros::ServiceServer> servers_;
};
}  // namespace f1tenth_sim2d
