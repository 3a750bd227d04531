#pragma once

#include <ros/callback_queue.h>
#include <sim2d_lockstep/participant.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "f1tenth_sim2d/publishing.h"
#include "node/time/lockstep_barrier.h"
#include "node/time/time_keeper.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
/// One control period at a time, each answered by every participant; docs/lockstep.md.
class LockstepTime : public TimeKeeper
{
public:
  LockstepTime(
    const Simulation & simulation, SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control,
    const Advertiser & advertiser, const ros::Publisher & clock, LockstepBarrier & barrier);
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
  const Advertiser & advertiser_;
  const ros::Publisher & clock_;
  LockstepBarrier & barrier_;
  sim2d_lockstep::InboxDrain drain_;
  std::map<std::string, std::optional<CarId>> cars_;  // each that was ever there; not set: none in this run
  std::uint64_t arrivals_{0};                         // of subscribers that have received the first period
};
}  // namespace f1tenth_sim2d
