#pragma once

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// State of a wheel or a steering joint, positive in the direction of its axis.
struct JointState
{
  double position{0.0};  ///< rad
  double velocity{0.0};  ///< rad/s; that of steering joints is not measured
};

JointState jointState(const JointDescription & joint, const Simulation & simulation, CarId car);
}  // namespace f1tenth_sim2d
