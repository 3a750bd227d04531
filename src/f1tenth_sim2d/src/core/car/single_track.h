#pragma once

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// State of the single-track model. The reference point is the centre of mass.
struct SingleTrackState
{
  double x{0.0};        ///< m
  double y{0.0};        ///< m
  double delta{0.0};    ///< rad, steering angle
  double v{0.0};        ///< m/s, speed of the centre of mass, negative in reverse
  double psi{0.0};      ///< rad, yaw, not wrapped
  double psi_dot{0.0};  ///< rad/s
  double beta{0.0};     ///< rad, slip angle at the centre of mass, within +-pi/2
  bool sliding{false};  ///< the tyres have lost their grip: friction decides, not the linear tyre
};

/// Inputs, constant over a step and already within the car's limits.
struct SingleTrackInput
{
  double steering_rate{0.0};  ///< rad/s
  double acceleration{0.0};   ///< m/s^2
};

/// Velocity of the centre of mass in the frame of the car, m/s.
Vec2 bodyVelocity(const SingleTrackState & state);
/// The same in the world.
Vec2 worldVelocity(const SingleTrackState & state);
/// Sets v and beta from the velocity of the centre of mass in the frame of the car, m/s.
void setBodyVelocity(SingleTrackState & state, const Vec2 & velocity);

/// The single-track model of CommonRoad (docs/core.md has the formulas, their source and the regimes).
class SingleTrack
{
public:
  explicit SingleTrack(const VehicleParameters & parameters);

  /// Advances state by dt, s.
  void advance(SingleTrackState & state, const SingleTrackInput & input, double dt) const;

private:
  /// Lateral forces, N, to the left.
  struct AxleForces
  {
    double front;
    double rear;
  };

  bool isDynamic(SingleTrackState & state) const;
  void advanceDynamic(SingleTrackState & state, const SingleTrackInput & input, double dt) const;
  void advanceWithGrip(SingleTrackState & state, const SingleTrackInput & input, double dt) const;
  AxleForces limitedForces(const AxleForces & wanted, double front_slip_free, double rear_slip_free, double dt) const;

  double m_;
  double I_z_;
  double l_f_;
  double l_r_;
  double wheelbase_;
  double h_;
  double front_stiffness_;  ///< mu C_Sf / wheelbase
  double rear_stiffness_;   ///< mu C_Sr / wheelbase
  double front_grip_;       ///< N, largest lateral force of the front axle
  double rear_grip_;        ///< N
};
}  // namespace f1tenth_sim2d
