#pragma once

#include <ros/callback_queue.h>
#include <rosgraph_msgs/Clock.h>
#include <sim2d_lockstep/participant.h>

#include <map>
#include <optional>
#include <string>

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
  void lookAtCars(SimTime begin);
  void greet(const std::string & name, CarId car);
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
  std::map<std::string, std::optional<CarId>> cars_;  // each that was ever there; not set: none in this run
  std::size_t subscribers_{0};                        // that have received the first period
};
}  // namespace f1tenth_sim2d
