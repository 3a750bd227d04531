#pragma once

#include <array>
#include <cstdint>

#include "core/car/vehicle_dynamics.h"
#include "core/car/wheel_odometry.h"
#include "core/math/cloned.h"
#include "core/math/planar_motion.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// How one car moves: the truth about it, in double precision, with its actuators and wheel odometry.
class Car
{
public:
  /// @param start         pose of base_footprint
  /// @param noise_stream  keeps its noise apart from that of the other cars
  Car(
    const CarDescription & description, const VehicleParameters & parameters, const Pose2 & start, std::uint64_t seed,
    std::uint32_t noise_stream);

  const VehicleParameters & parameters() const { return parameters_; }
  const BodyState & dynamicState() const { return state_; }
  const WheelOdometry & wheelOdometry() const { return odometry_.current(); }

  /// Puts base_footprint at a pose with a velocity (m/s, in the frame of the car) and a yaw rate (rad/s).
  void place(const Pose2 & pose, const Vec2 & velocity = {}, double yaw_rate = 0.0);
  /// Back to the start pose, at rest.
  void restart(SimTime now);

  /// As VehicleDynamics takes them.
  void command(const DriveCommand & command, SimTime now) { dynamics_->command(command, now); }
  void command(const TwistCommand & command, SimTime now) { dynamics_->command(command, now); }

  /// Works out where the car goes in a step of dt seconds that starts at now, without contacts.
  void predict(SimTime now, double dt);
  /// The farthest that a point of the car within outer_radius (m) of its centre of mass moves in the predicted step, m.
  double predictedTravel(double outer_radius) const;
  /// Where the car is, with the velocity that it has at the end of the predicted step.
  PlanarMotion predictedMotion() const;
  /// Replaces the predicted motion by what contacts made of it.
  void apply(const ContactEffect & effect);
  /// Makes the prediction true, at time now.
  void commit(SimTime now, double dt);

  /// Pose of base_footprint, m and rad.
  Pose2 pose() const;
  /// Pose of the centre of mass, m and rad.
  Pose2 centreOfMass() const { return {state_.x, state_.y, state_.psi}; }
  CarState state() const;

private:
  VehicleParameters parameters_;
  Pose2 start_;
  Cloned<VehicleDynamics> dynamics_;
  WheelOdometryIntegrator odometry_;
  BodyState state_;
  BodyState predicted_;
  Vec2 velocity_;                         ///< m/s, of the centre of mass, in the world
  double rolling_speed_{0.0};             ///< m/s, of the rear axle
  Vec2 acceleration_;                     ///< m/s^2, of the centre of mass, in the world
  std::array<double, 4> wheel_angles_{};  ///< rad
  std::array<double, 4> wheel_speeds_{};  ///< rad/s
};
}  // namespace f1tenth_sim2d
