#pragma once

#include "core/car/delayed_command.h"
#include "core/car/vehicle_dynamics.h"

namespace f1tenth_sim2d
{
/// The twist of a car of this wheelbase at a speed and a steering angle.
TwistCommand twistFromCommand(const DriveCommand & command, double wheelbase);

/// The drives of gazebo_ros that set velocities: differential, skid-steer and planar. The car takes the velocity that
/// it is asked for, as fast as its acceleration allows, and turns about the point given by its wheels; only a planar
/// one moves sideways. The steering angle stays zero.
class TwistDrive : public VehicleDynamics
{
public:
  /// Whether a car has such a drive, and no steering joints: a car that has these is driven by them.
  static bool drives(const CarDescription & car);

  /// @param car  that has such a drive
  TwistDrive(const CarDescription & car, const VehicleParameters & parameters);
  std::unique_ptr<VehicleDynamics> clone() const override { return std::make_unique<TwistDrive>(*this); }

  void restart() override;
  void command(const DriveCommand & command, SimTime now) override;
  void command(const TwistCommand & command, SimTime now) override;
  void advance(BodyState & state, double rear_speed, SimTime now, double dt) override;

  bool steers() const override { return false; }
  WheelMotion wheels(const BodyState & state) const override;

private:
  TwistCommand limited(const TwistCommand & command) const;
  Vec2 approached(const Vec2 & velocity, const Vec2 & wanted, double dt) const;

  VehicleParameters parameters_;
  double track_width_;   ///< m
  double wheel_radius_;  ///< m
  bool goes_sideways_;
  double centre_ahead_;              ///< m, how far the centre of mass is ahead of the point that the car turns about
  double acceleration_max_;          ///< m/s^2
  double angular_acceleration_max_;  ///< rad/s^2
  DelayedCommand<TwistCommand> commands_;
};
}  // namespace f1tenth_sim2d
