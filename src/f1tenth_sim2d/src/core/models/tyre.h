#pragma once

#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// A force of the ground on the tyres of an axle, N, and how it grows with its own slip.
struct TyreForce
{
  double value{0.0};
  double slope{0.0};  ///< N per unit of slip, or per rad
};

/// In the frame of the wheels.
struct TyreForces
{
  TyreForce along;
  TyreForce aside;  ///< to the left
};

/// Pacejka's magic formula for combined slip, as in CommonRoad's vehicle models (M. Althoff, G. Wuersching:
/// "CommonRoad: Vehicle Models", 2020, section "Tire Model"): no camber, no turn slip, all scaling factors 1 except
/// that of friction, which is mu / p_dy1 in both directions.
class Tyre
{
public:
  explicit Tyre(const VehicleParameters & parameters);

  /// @param slip   speed of the circumference over that of the ground, less 1: positive when driven
  /// @param angle  rad, from where the wheels point to where they go, positive to the left
  /// @param load   N
  TyreForces forces(double slip, double angle, double load) const;

private:
  TyreForce alongPure(double slip, double load) const;
  TyreForce asidePure(double angle, double load) const;
  double alongShare(double slip, double angle) const;
  double asideShare(double slip, double angle) const;
  double asideBySlip(double slip, double angle, double load) const;

  TireParameters tire_;
  double friction_along_;  ///< peak force over load
  double friction_aside_;
};
}  // namespace f1tenth_sim2d
