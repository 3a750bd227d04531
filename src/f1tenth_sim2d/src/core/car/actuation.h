#pragma once

#include "core/car/delayed_command.h"
#include "core/models/steered_model.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// A Twist as a drive command: the steering angle with which a car of this wheelbase turns with angular_z at
/// linear_x. A car cannot turn on the spot: at linear_x = 0 the wheels turn to the side of angular_z.
DriveCommand commandFromTwist(double linear_x, double angular_z, double wheelbase);

/// Acceleration that the motor can give at speed v, m/s and m/s^2; the limits of CommonRoad's models.
double limitedAcceleration(double v, double acceleration, const VehicleParameters & parameters);

/// Between the driver's commands and the inputs of a model: latency, timeout, speed control, limits.
class Actuation
{
public:
  explicit Actuation(const VehicleParameters & parameters);

  /// Takes a command at now; it takes effect after the latency. Its values must be finite.
  void command(const DriveCommand & command, SimTime now);

  /// Inputs for a step of dt seconds that starts at now.
  /// @param speed           m/s, as the motor knows it from the wheels
  /// @param steering_angle  rad, now
  SteeredInput input(double speed, double steering_angle, SimTime now, double dt);

private:
  double speedControl(double wanted, double speed, double dt) const;

  VehicleParameters parameters_;
  DelayedCommand<DriveCommand> commands_;
};
}  // namespace f1tenth_sim2d
