#pragma once

#include <ros/callback_queue.h>
#include <sim2d_lockstep/participant.h>

#include "node/time/pacer.h"
#include "node/time/time_keeper.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
/// As fast as possible, but no faster than what is published reaches the sockets: a subscriber that keeps up loses
/// nothing.
class FreeTime : public TimeKeeper
{
public:
  FreeTime(SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control)
  : world_(world), queue_(queue), control_(control)
  {
  }
  /// By one control period.
  void advance() override;

private:
  SimulatedWorld & world_;
  ros::CallbackQueue & queue_;
  const TimeControl & control_;
  sim2d_lockstep::InboxDrain drain_;
};

/// A fixed number of simulated seconds per wall second, if the machine can.
class PacedTime : public TimeKeeper
{
public:
  PacedTime(SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control);
  void advance() override;
  void restart() override;

private:
  bool serveCallbacksUntilDue(SimTime next);

  SimulatedWorld & world_;
  ros::CallbackQueue & queue_;
  const TimeControl & control_;
  Pacer pacer_;
};
}  // namespace f1tenth_sim2d
