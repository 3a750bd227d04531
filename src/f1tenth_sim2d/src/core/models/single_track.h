#pragma once

#include "core/models/rolling_with_grip.h"
#include "core/models/steered_model.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// The single-track model of CommonRoad (docs/core.md has the formulas, their source and the regimes).
class SingleTrack : public SteeredModel
{
public:
  explicit SingleTrack(const VehicleParameters & parameters);
  std::unique_ptr<SteeredModel> clone() const override { return std::make_unique<SingleTrack>(*this); }

  void restart(const BodyState & state) override;
  void advance(BodyState & state, const SteeredInput & input, double dt) override;
  /// Whether the tyres have lost their grip: friction decides, not the linear tyre.
  bool isSliding() const { return sliding_; }

private:
  bool isDynamic(const BodyState & state);
  void advanceDynamic(BodyState & state, const SteeredInput & input, double dt) const;

  double m_;
  double I_z_;
  double l_f_;
  double l_r_;
  double h_;
  double front_stiffness_;  ///< mu C_Sf / wheelbase
  double rear_stiffness_;   ///< mu C_Sr / wheelbase
  RollingWithGrip low_speed_;
  bool sliding_{false};
};
}  // namespace f1tenth_sim2d
