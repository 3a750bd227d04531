#pragma once

#include "core/models/body_state.h"
#include "core/models/steered_model.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// A car whose wheels roll where they point as long as friction holds it there, and slides beyond; at any speed, also at
/// rest and in reverse.
class RollingWithGrip
{
public:
  explicit RollingWithGrip(const VehicleParameters & parameters);

  /// Advances state by dt, s.
  void advance(BodyState & state, const SteeredInput & input, double dt) const;

private:
  /// Lateral forces, N, to the left.
  struct AxleForces
  {
    double front;
    double rear;
  };

  AxleForces limitedForces(const AxleForces & wanted, double front_slip_free, double rear_slip_free, double dt) const;

  double m_;
  double I_z_;
  double l_f_;
  double l_r_;
  double wheelbase_;
  double front_grip_;  ///< N, largest lateral force of the front axle
  double rear_grip_;   ///< N
};
}  // namespace f1tenth_sim2d
