#pragma once

#include <ros/callback_queue.h>

#include "node/time/pacer.h"
#include "node/time/time_keeper.h"
#include "node/transport/flow_control.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
/// As fast as possible.
class FreeTime : public TimeKeeper
{
public:
  FreeTime(SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control, FlowControl & flow)
  : world_(world), queue_(queue), control_(control), flow_(flow)
  {
  }
  /// By one control period.
  void advance() override;

private:
  SimulatedWorld & world_;
  ros::CallbackQueue & queue_;
  const TimeControl & control_;
  FlowControl & flow_;
};

/// A fixed number of simulated seconds per wall second, if the machine can.
class PacedTime : public TimeKeeper
{
public:
  PacedTime(SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control, FlowControl & flow);
  void advance() override;
  void restart() override;

private:
  bool serveCallbacksUntilDue(SimTime next);

  SimulatedWorld & world_;
  ros::CallbackQueue & queue_;
  const TimeControl & control_;
  FlowControl & flow_;
  Pacer pacer_;
};
}  // namespace f1tenth_sim2d
