#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <sim2d_lockstep/participant.h>

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "f1tenth_sim2d/publishing.h"
#include "node/app/run_result.h"
#include "node/cars/fleet.h"
#include "node/cars/plugin_host.h"
#include "node/gazebo_api/gazebo_models.h"
#include "node/gazebo_api/gazebo_world.h"
#include "node/messages/transform_batch.h"
#include "node/parameters/node_parameters.h"
#include "node/time/lockstep_barrier.h"
#include "node/time/time_keeper.h"
#include "node/world/intervention_log.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
/// The simulator as a ROS node: builds everything, then lets time pass. One thread; every callback runs on it, between
/// physics steps.
class Sim2dNode
{
public:
  /// @throws Error for what cannot be used
  explicit Sim2dNode(const NodeParameters & parameters);

  /// Runs until somebody asks for the end.
  /// @throws ParticipantSilent
  void run();
  /// What has happened so far, without a reason for the end.
  RunResult result() const;

private:
  std::unique_ptr<LockstepBarrier> makeBarrier();
  Fleet::Surroundings surroundings();
  OutputList globalOutputs();
  void addClock();
  std::unique_ptr<TimeKeeper> makeTimeKeeper();
  void restart();

  // Each refers only to those before it, and so is destroyed before them.
  const NodeParameters parameters_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  sim2d_lockstep::InboxDrain drain_;  // before anything is advertised
  Advertiser advertiser_;
  TransformBatch transforms_;
  Simulation simulation_;
  PluginHost plugins_;
  SimulatedWorld world_;
  const std::string world_sha256_;
  std::map<std::string, std::string> cars_sha256_;
  InterventionLog interventions_;
  TimeControl control_;
  ros::Publisher clock_;
  std::unique_ptr<LockstepBarrier> barrier_;  // in lockstep only
  Fleet fleet_;
  std::optional<RunningOutputs> global_outputs_;
  GazeboModels models_;
  GazeboWorld world_services_;
  ros::WallTime wall_start_;
};
}  // namespace f1tenth_sim2d
