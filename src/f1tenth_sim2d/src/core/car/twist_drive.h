#pragma once

#include "core/car/delayed_command.h"
#include "core/car/single_track.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/commands.h"

namespace f1tenth_sim2d
{
/// The twist that a car of this wheelbase has at a speed and under a steering angle.
TwistCommand twistFromCommand(const DriveCommand & command, double wheelbase);

/// The drives of gazebo_ros that set velocities: differential, skid-steer and planar. The car takes the velocity that it is
/// asked for, as fast as its acceleration allows, and turns about the point that its wheels turn it about; only a
/// planar one goes sideways. The state is that of the single-track model, with the steering angle at zero.
class TwistDrive
{
public:
  /// Whether a car has such a drive, and no steering joints: a car that has these is driven by them.
  static bool drives(const CarDescription & car);

  /// @param car  that has one
  TwistDrive(const CarDescription & car, const VehicleParameters & parameters);

  /// Takes a command at now; it takes effect after the latency. Its values must be finite.
  void command(const TwistCommand & command, SimTime now);
  /// Forgets all commands.
  void restart();

  /// Advances state by a step of dt seconds that starts at now.
  void advance(SingleTrackState & state, SimTime now, double dt);

private:
  TwistCommand limited(const TwistCommand & command) const;
  Vec2 approached(const Vec2 & velocity, const Vec2 & wanted, double dt) const;

  VehicleParameters parameters_;
  bool goes_sideways_;
  double centre_ahead_;              ///< m, how far the centre of mass is ahead of the point it turns about
  double acceleration_max_;          ///< m/s^2
  double angular_acceleration_max_;  ///< rad/s^2
  DelayedCommand<TwistCommand> commands_;
};
}  // namespace f1tenth_sim2d
