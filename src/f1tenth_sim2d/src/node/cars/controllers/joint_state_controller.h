#pragma once

#include "node/cars/car_outputs.h"
#include "node/cars/controllers/controller.h"
#include "node/cars/controllers/controller_setup.h"
#include "node/world/schedule.h"

namespace f1tenth_sim2d
{
/// Publishes `joint_states` of all wheels and steering joints; moves none.
class JointStateController : public Controller
{
public:
  explicit JointStateController(const ControllerSetup & setup);

  Claim claim() const override;
  void start(SimTime now) override;
  void publish(SimTime now) override { schedule_.run(now); }

private:
  JointStatesOutput output_;
  Schedule schedule_;
};
}  // namespace f1tenth_sim2d
