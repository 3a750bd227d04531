#pragma once

#include <array>
#include <memory>

#include "core/models/body_state.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
struct WheelMotion
{
  double rear_speed{0.0};          ///< m/s, mean circumferential speed of the rear wheels
  std::array<double, 4> speeds{};  ///< rad/s: front left, front right, rear left, rear right
};

/// How a car moves when nothing touches it: from the driver's commands to the motion of its centre of mass.
class VehicleDynamics
{
public:
  virtual ~VehicleDynamics() = default;
  virtual std::unique_ptr<VehicleDynamics> clone() const = 0;

  /// Forgets all commands.
  virtual void restart() = 0;
  /// The car was put somewhere; commands stay in force.
  virtual void place(const BodyState & /*state*/) {}

  /// Commands of the driver at now, within the limits of validation.h; they take effect after the car's latency. Either
  /// kind serves every car: one that steers converts a twist to a steering angle, the others convert a steering angle
  /// to a twist.
  virtual void command(const DriveCommand & command, SimTime now) = 0;
  virtual void command(const TwistCommand & command, SimTime now) = 0;

  /// Advances state by a step of dt seconds that starts at now.
  /// @param rear_speed  m/s, of the wheels in that state, as wheels() gives it
  virtual void advance(BodyState & state, double rear_speed, SimTime now, double dt) = 0;

  /// Whether the car steers, so that its wheel odometry uses the steering angle and not the difference of two wheels.
  virtual bool steers() const = 0;
  virtual WheelMotion wheels(const BodyState & state) const = 0;
};
}  // namespace f1tenth_sim2d
