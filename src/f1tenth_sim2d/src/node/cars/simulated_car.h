#pragma once

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// A car that is in the simulation as long as this exists.
class SimulatedCar
{
public:
  /// @throws Error as Simulation::addCar
  SimulatedCar(
    Simulation & simulation, const CarDescription & description, const VehicleParameters & parameters,
    const Pose2 & pose)
  : simulation_(simulation), id_(simulation.addCar(description, parameters, pose))
  {
  }
  ~SimulatedCar() { simulation_.removeCar(id_); }
  SimulatedCar(const SimulatedCar &) = delete;
  SimulatedCar & operator=(const SimulatedCar &) = delete;

  CarId id() const { return id_; }

private:
  Simulation & simulation_;
  const CarId id_;
};
}  // namespace f1tenth_sim2d
