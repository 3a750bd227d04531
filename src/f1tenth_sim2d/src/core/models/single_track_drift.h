#pragma once

#include <workspace_support/maths/trigonometry.h>

#include "core/models/rolling_with_grip.h"
#include "core/models/steered_model.h"
#include "core/models/tyre.h"
#include "core/models/wheel_footing.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// The single-track drift model of CommonRoad: wheels that spin and lock, tyres that slide (docs/core.md).
class SingleTrackDrift : public SteeredModel
{
public:
  explicit SingleTrackDrift(const VehicleParameters & parameters);
  std::unique_ptr<SteeredModel> clone() const override { return std::make_unique<SingleTrackDrift>(*this); }

  void restart(const BodyState & state) override;
  void advance(BodyState & state, const SteeredInput & input, double dt) override;
  std::optional<AxleSpeeds> axleSpeeds() const override;

private:
  /// What has dynamics of its own.
  struct Motion
  {
    double v_x;      ///< m/s, of the centre of mass, along the car
    double v_y;      ///< m/s, to its left
    double psi_dot;  ///< rad/s
    double omega_f;  ///< rad/s, of the front wheels
    double omega_r;  ///< rad/s
  };
  /// What makes the motion stiff, for a step of some length.
  struct Damping
  {
    double front_wheel;  ///< N s/rad, by which the front tyres push more when their wheels turn faster
    double rear_wheel;   ///< N s/rad
    double aside;        ///< share of the velocity to the side that is lost
    double turning;      ///< share of the yaw rate that is lost
  };
  /// What the ground does to the car.
  struct Footing
  {
    WheelFooting front;
    WheelFooting rear;
  };
  /// Torques on the wheels of the axles, N m.
  struct Torques
  {
    double front;
    double rear;
    bool brake;
  };

  friend Motion operator+(const Motion & a, const Motion & b);
  friend Motion operator*(double s, const Motion & a);
  void advanceSliding(BodyState & state, const SteeredInput & input, double dt);
  void roll(const BodyState & state);
  static Motion braked(const Motion & motion, const Torques & torques);
  Torques torques(const Motion & motion, double acceleration) const;
  Footing footing(const Motion & motion, const maths::SineCosine & steering, double acceleration) const;
  Motion slope(
    const Motion & motion, const Footing & footing, const maths::SineCosine & steering, const Torques & torques) const;
  Damping damping(const Footing & footing, double dt) const;
  Motion damped(const Motion & slope, const Damping & damping, const maths::SineCosine & steering) const;

  double m_;
  double I_z_;
  double l_f_;
  double l_r_;
  double h_;
  double wheelbase_;
  double R_w_;
  double I_y_w_;
  double brake_split_;   ///< share of the front axle
  double engine_split_;  ///< share of the front axle
  double grip_;          ///< m/s^2, the most that motor and brakes can give
  Tyre tyre_;
  RollingWithGrip low_speed_;
  double omega_f_{0.0};  ///< rad/s, of the front wheels
  double omega_r_{0.0};  ///< rad/s
};
}  // namespace f1tenth_sim2d
