#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>

#include <memory>
#include <vector>

#include "clock_publisher.h"
#include "fleet.h"
#include "flow_control.h"
#include "gazebo_models.h"
#include "gazebo_world.h"
#include "lockstep_barrier.h"
#include "node_parameters.h"
#include "outbox.h"
#include "plugin_host.h"
#include "run_result.h"
#include "scene.h"
#include "simulated_world.h"
#include "time_keeper.h"
#include "transform_batch.h"

namespace f1tenth_sim2d
{
/// The simulator as a ROS node: builds everything, then lets time pass. One thread; every callback runs on it, between
/// physics steps.
class Sim2dNode
{
public:
  /// @throws Error for what cannot be used
  explicit Sim2dNode(const NodeParameters & parameters);

  /// Until somebody asks for the end.
  /// @throws ParticipantSilent
  void run();
  /// What has happened so far, without a reason for the end.
  RunResult result() const;

private:
  void addGlobalOutputs();
  std::unique_ptr<LockstepBarrier> makeBarrier();
  void addTime();
  std::unique_ptr<TimeKeeper> makeTimeKeeper();
  void restart();

  const NodeParameters parameters_;
  ros::CallbackQueue queue_;  // before everything that refers to it
  ros::NodeHandle node_;
  Outbox outbox_;
  FlowControl flow_;
  TransformBatch transforms_;
  Scene scene_;
  PluginHost plugins_;  // before the world, which holds what they make
  SimulatedWorld world_;
  TimeControl control_;
  ClockPublisher clock_;
  std::unique_ptr<LockstepBarrier> barrier_;  // in lockstep only
  Fleet fleet_;
  GazeboModels models_;
  GazeboWorld world_services_;
  ros::WallTime wall_start_;
};
}  // namespace f1tenth_sim2d
