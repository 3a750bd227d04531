#pragma once

#include <memory>

#include "core/car/actuation.h"
#include "core/car/vehicle_dynamics.h"
#include "core/math/cloned.h"
#include "core/models/steered_model.h"

namespace f1tenth_sim2d
{
/// A car that is driven by a speed and a steering angle: actuators in front of a model of its motion.
class SteeredDrive : public VehicleDynamics
{
public:
  SteeredDrive(const CarDescription & car, const VehicleParameters & parameters, std::unique_ptr<SteeredModel> model);
  std::unique_ptr<VehicleDynamics> clone() const override { return std::make_unique<SteeredDrive>(*this); }

  void restart() override;
  void place(const BodyState & state) override;
  void command(const DriveCommand & command, SimTime now) override;
  void command(const TwistCommand & command, SimTime now) override;
  void advance(BodyState & state, double rear_speed, SimTime now, double dt) override;

  bool steers() const override { return true; }
  WheelMotion wheels(const BodyState & state) const override;

private:
  const VehicleParameters parameters_;
  const double track_width_;   ///< m
  const double wheel_radius_;  ///< m
  Actuation actuation_;
  Cloned<SteeredModel> model_;
};
}  // namespace f1tenth_sim2d
