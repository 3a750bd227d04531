#include "node/cars/controllers/joint_state_controller.h"

#include "node/parameters/limits.h"

namespace f1tenth_sim2d
{
namespace
{
double publishRate(const ControllerSetup & setup)
{
  double rate_hz = 50.0;
  setup.parameters().read("publish_rate", rate_hz, frequency());
  return rate_hz;
}
}  // namespace

JointStateController::JointStateController(const ControllerSetup & setup)
: output_(setup.car, "joint_states", publishRate(setup), setup.car.description().mechanism)
{
}

Controller::Claim JointStateController::claim() const
{
  Claim claim;
  claim.hardware_interface = "hardware_interface::JointStateInterface";
  return claim;
}

void JointStateController::start(SimTime now)
{
  schedule_ = {};
  schedule_.add(
    periodOf(output_.rate()), [this](SimTime at) { output_.update(at, false); }, now);
}
}  // namespace f1tenth_sim2d
