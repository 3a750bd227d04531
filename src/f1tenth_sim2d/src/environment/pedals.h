#pragma once

#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// Turns rates that a driver asks for into the targets that a car follows.
class Pedals
{
public:
  explicit Pedals(const VehicleParameters & parameters, double speed);

  /// The command of the next physics step.
  /// @param steering_rate  rad/s
  /// @param acceleration   m/s^2
  /// @param dt             s
  DriveCommand press(const CarState & state, double steering_rate, double acceleration, double dt);

private:
  VehicleParameters parameters_;
  double speed_;                ///< m/s, that the driver has asked for so far
  double steering_angle_{0.0};  ///< rad, likewise
};
}  // namespace f1tenth_sim2d
