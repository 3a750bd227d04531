#pragma once

#include "core/models/steered_model.h"
#include "f1tenth_sim2d/vehicle_parameters.h"

namespace f1tenth_sim2d
{
/// The kinematic single-track model of CommonRoad: the wheels go where they point, whatever force that takes.
class Kinematic : public SteeredModel
{
public:
  explicit Kinematic(const VehicleParameters & parameters);
  std::unique_ptr<SteeredModel> clone() const override { return std::make_unique<Kinematic>(*this); }

  void advance(BodyState & state, const SteeredInput & input, double dt) override;

private:
  const double wheelbase_;   ///< m
  const double rear_share_;  ///< l_r over the wheelbase
};
}  // namespace f1tenth_sim2d
