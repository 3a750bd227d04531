#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/car/actuation.h"
#include "core/car/single_track.h"
#include "core/car/twist_drive.h"
#include "core/car/wheel_odometry.h"
#include "core/math/planar_motion.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/car_state.h"
#include "f1tenth_sim2d/commands.h"
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
  const SingleTrackState & dynamicState() const { return state_; }
  const WheelOdometry & wheelOdometry() const { return odometry_.current(); }

  /// Puts base_footprint at a pose with a velocity (m/s, in the frame of the car) and a yaw rate (rad/s).
  void place(const Pose2 & pose, const Vec2 & velocity = {}, double yaw_rate = 0.0);
  /// Back to the start pose, at rest.
  void restart(SimTime now);

  /// Commands of the driver at now, within the limits of validation.h. Either kind serves either kind of car: one that is
  /// driven by velocities takes a steering angle as the yaw rate that it means, and the other way round.
  void command(const DriveCommand & command, SimTime now);
  void commandTwist(const TwistCommand & command, SimTime now);

  /// Works out where the car goes in a step of dt seconds that starts at now, contacts left aside.
  void predict(SimTime now, double dt);
  /// The farthest that a point of the car within outer_radius (m) of its centre of mass goes in the predicted step, m.
  double predictedTravel(double outer_radius) const;
  /// Where the car is, with the velocity that it has at the end of the predicted step.
  PlanarMotion predictedMotion() const;
  /// Puts what contacts made of it in place of the predicted motion.
  void apply(const ContactEffect & effect);
  /// Makes the prediction true, at time now.
  void commit(SimTime now, double dt);

  /// Pose of base_footprint, m and rad.
  Pose2 pose() const;
  /// Pose of the centre of mass, m and rad.
  Pose2 centreOfMass() const { return {state_.x, state_.y, state_.psi}; }
  CarState state() const;

private:
  void turnWheels(double dt);

  VehicleParameters parameters_;
  double track_width_;   ///< m
  double wheel_radius_;  ///< m
  Pose2 start_;
  SingleTrack model_;
  Actuation actuation_;
  std::optional<TwistDrive> twist_drive_;  ///< of a car that is driven by velocities
  WheelOdometryIntegrator odometry_;
  SingleTrackState state_;
  SingleTrackState predicted_;
  Vec2 velocity_;                         ///< m/s, of the centre of mass, in the world
  double speed_{0.0};                     ///< m/s, along the car
  Vec2 acceleration_;                     ///< m/s^2, of the centre of mass, in the world
  std::array<double, 4> wheel_angles_{};  ///< rad
  std::array<double, 4> wheel_speeds_{};  ///< rad/s
};
}  // namespace f1tenth_sim2d
