#include "core/car/vehicle_dynamics.h"

#include "core/car/steered_drive.h"
#include "core/car/twist_drive.h"
#include "core/models/kinematic.h"
#include "core/models/single_track.h"
#include "core/models/single_track_drift.h"

namespace f1tenth_sim2d
{
namespace
{
std::unique_ptr<SteeredModel> makeModel(const VehicleParameters & parameters)
{
  switch (parameters.model) {
    case VehicleModel::kKinematic:
      return std::make_unique<Kinematic>(parameters);
    case VehicleModel::kSingleTrackDrift:
      return std::make_unique<SingleTrackDrift>(parameters);
    default:
      return std::make_unique<SingleTrack>(parameters);
  }
}
}  // namespace

std::unique_ptr<VehicleDynamics> makeVehicleDynamics(const CarDescription & car, const VehicleParameters & parameters)
{
  if (TwistDrive::drives(car)) {
    return std::make_unique<TwistDrive>(car, parameters);
  }
  return std::make_unique<SteeredDrive>(car, parameters, makeModel(parameters));
}
}  // namespace f1tenth_sim2d
