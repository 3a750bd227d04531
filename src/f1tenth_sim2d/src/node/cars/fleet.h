#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "node/cars/car_outputs.h"
#include "node/cars/command_input.h"
#include "node/cars/plugin_host.h"
#include "node/parameters/node_parameters.h"
#include "node/world/simulated_world.h"

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

/// What the node keeps for each car of the simulation: what it publishes, its plugins and its driver.
class Fleet
{
public:
  /// Everything outlives the fleet.
  struct Surroundings
  {
    OdometryOwner odometry;
    ros::NodeHandle node;  ///< its callback queue must be served by the simulation's thread
    Simulation & simulation;
    SimulatedWorld & world;
    Advertiser & advertiser;
    TransformSender & transforms;
    PluginHost & plugins;
    /// What is to be called for every command of a car's driver.
    std::function<CommandInput::Answered(const std::string & car)> driver_of;
  };

  struct Driver
  {
    std::string car;
    const CommandInput & commands;
  };

  explicit Fleet(Surroundings surroundings);

  /// All or nothing, whatever is thrown.
  /// @throws Error for a car that cannot be used
  void add(
    const CarParameters & car, const CarDescription & description, const VehicleParameters & vehicle,
    const Pose2 & pose);
  void remove(CarId car) { cars_.erase(car); }
  std::vector<Driver> drivers() const;

private:
  /// Its members undo what they did when it is destroyed, even half-built: the last one first.
  struct Car
  {
    Car(
      Fleet & fleet, const CarParameters & car, const CarDescription & description, const VehicleParameters & vehicle,
      const Pose2 & pose);

    const CarParameters parameters;
    const SimulatedCar simulated;
    CommandInput commands;
    const RunningOutputs outputs;
  };

  CarHandle handleOf(const Car & car) const;
  OutputList makeOutputs(Car & car) const;
  void addOdometry(const CarHandle & car, OutputList & outputs) const;
  void addPlugins(const CarHandle & car, OutputList & outputs) const;

  const Surroundings around_;
  std::map<CarId, std::unique_ptr<Car>> cars_;
};
}  // namespace f1tenth_sim2d
