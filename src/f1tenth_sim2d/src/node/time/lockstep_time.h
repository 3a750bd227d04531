#pragma once

#include <ros/callback_queue.h>
#include <rosgraph_msgs/Clock.h>
#include <sim2d_lockstep/participant.h>

#include "f1tenth_sim2d/publishing.h"
#include "node/time/lockstep_barrier.h"
#include "node/time/time_keeper.h"
#include "node/transport/flow_control.h"
#include "node/transport/outbox.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
/// One control period at a time, each answered by every participant; docs/lockstep.md.
class LockstepTime : public TimeKeeper
{
public:
  LockstepTime(
    const Simulation & simulation, SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control,
    Outbox & outbox, FlowControl & flow, const TopicPublisher<rosgraph_msgs::Clock> & clock, LockstepBarrier & barrier);
  /// @throws ParticipantSilent
  void advance() override;

private:
  void excuseFrom(SimTime begin);
  void publishClock();
  void repeatPeriod();

  const Simulation & simulation_;
  SimulatedWorld & world_;
  ros::CallbackQueue & queue_;
  const TimeControl & control_;
  Outbox & outbox_;
  FlowControl & flow_;
  const TopicPublisher<rosgraph_msgs::Clock> & clock_;
  LockstepBarrier & barrier_;
  sim2d_lockstep::InboxDrain drain_;
  std::size_t subscribers_{0};  // that have had the first period
};
}  // namespace f1tenth_sim2d
