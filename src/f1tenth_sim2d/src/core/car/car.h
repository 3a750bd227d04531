#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/car/actuation.h"
#include "core/car/single_track.h"
#include "core/car/twist_drive.h"
#include "core/car/wheel_odometry.h"
#include "core/contacts/clearance.h"
#include "core/contacts/collision_world.h"
#include "core/contacts/contact_log.h"
#include "core/lidar/lidar_sensor.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/car_state.h"
#include "f1tenth_sim2d/commands.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// One car: the truth about it, in double precision, and its actuators and sensors.
class Car
{
public:
  /// @param index  among the cars of the world
  /// @param start  pose of base_footprint
  Car(
    std::size_t index, std::uint32_t noise_stream, const CarDescription & description,
    const VehicleParameters & parameters, const Pose2 & start, std::uint64_t seed, WorldPieces & world);

  /// Keeps its noise apart from that of the other cars.
  std::uint32_t noiseStream() const { return noise_stream_; }
  const CarDescription & description() const { return description_; }
  const VehicleParameters & parameters() const { return parameters_; }
  const std::vector<Piece> & pieces() const { return pieces_; }
  CarBody body() const { return {pieces_, parameters_.m, parameters_.I_z}; }
  /// How many layers the world has with this car and those before it.
  std::size_t layerCount() const { return layer_count_; }
  PlacedCar placed() const;
  const SingleTrackState & dynamicState() const { return state_; }
  const WheelOdometry & wheelOdometry() const { return odometry_.current(); }
  ContactLog & contactLog() { return contacts_; }
  const ContactLog & contactLog() const { return contacts_; }
  std::vector<LidarSensor> & lidars() { return lidars_; }

  /// Puts base_footprint at a pose with a velocity (m/s, in the frame of the car) and a yaw rate (rad/s).
  void place(const Pose2 & pose, const Vec2 & velocity = {}, double yaw_rate = 0.0);
  /// Becomes the car of this index in a world that was worked out anew. Its lidars do not notice.
  void moveInto(std::size_t index, WorldPieces & world);
  /// Back to the start pose, at rest.
  void restart(SimTime now);

  /// Commands of the driver at now, within the limits of validation.h. Either kind serves either kind of car: one that is
  /// driven by velocities takes a steering angle as the yaw rate that it means, and the other way round.
  void command(const DriveCommand & command, SimTime now);
  void commandTwist(const TwistCommand & command, SimTime now);

  /// Works out where the car goes in a step of dt seconds that starts at now, contacts left aside.
  void predict(SimTime now, double dt);
  /// The farthest that a point of the car goes in the predicted step, m.
  double predictedTravel() const;
  /// Where the car is, with the velocity that it has at the end of the predicted step.
  CarMotion predictedMotion() const;
  /// Puts what contacts made of it in place of the predicted motion.
  void apply(const ContactEffect & effect);
  /// Makes the prediction true, at time now.
  void commit(SimTime now, double dt);

  /// Pose of base_footprint, m and rad.
  Pose2 pose() const;
  const CarState & state() const;

private:
  void turnWheels(double dt);
  void updateState() const;

  std::uint32_t noise_stream_;
  CarDescription description_;
  VehicleParameters parameters_;
  Pose2 start_;
  std::vector<Piece> pieces_;
  std::size_t layer_count_;
  double outer_radius_;
  SingleTrack model_;
  Actuation actuation_;
  std::optional<TwistDrive> twist_drive_;  ///< of a car that is driven by velocities
  WheelOdometryIntegrator odometry_;
  std::vector<LidarSensor> lidars_;
  ContactLog contacts_;
  SingleTrackState state_;
  SingleTrackState predicted_;
  Vec2 velocity_;                         ///< m/s, of the centre of mass, in the world
  double speed_{0.0};                     ///< m/s, along the car
  Vec2 acceleration_;                     ///< m/s^2, of the centre of mass, in the world
  std::array<double, 4> wheel_angles_{};  ///< rad
  std::array<double, 4> wheel_speeds_{};  ///< rad/s
  mutable CarState reported_;             ///< made from the above when somebody asks
  mutable bool reported_is_current_{false};
};
}  // namespace f1tenth_sim2d
