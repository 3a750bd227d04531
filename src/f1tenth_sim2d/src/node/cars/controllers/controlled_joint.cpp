#include "node/cars/controllers/controlled_joint.h"

namespace f1tenth_sim2d
{
void ControlledJoint::restart()
{
  if (pid_) {
    pid_->restart();
  }
}

std::string ControlledJoint::objectionTo(double value) const
{
  return f1tenth_sim2d::objectionTo({kind_, joint_, value}, wheel_radius_);
}

JointCommand ControlledJoint::command(double value, double speed, double dt)
{
  if (!pid_ || dt <= 0.0) {
    return {kind_, joint_, value};
  }
  return {JointCommand::Kind::kEffort, joint_, pid_->effort(value - speed, dt, joint_.effort_max)};
}
}  // namespace f1tenth_sim2d
