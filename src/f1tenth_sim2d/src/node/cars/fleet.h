#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>
#include <vector>

#include "node/app/diagnostics_output.h"
#include "node/cars/command_input.h"
#include "node/cars/plugin_host.h"
#include "node/messages/transform_batch.h"
#include "node/parameters/node_parameters.h"
#include "node/time/lockstep_barrier.h"
#include "node/transport/outbox.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
/// All cars of the node: each in the simulation, with what it publishes, its plugins and its driver.
class Fleet
{
public:
  struct Surroundings
  {
    const NodeParameters & parameters;
    double gravity;        ///< m/s^2, downwards
    ros::NodeHandle node;  ///< its callback queue must be served by the simulation's thread
    Simulation & simulation;
    SimulatedWorld & world;
    Outbox & outbox;
    TransformBatch & transforms;
    PluginHost & plugins;       ///< must outlive the world, which holds the plugins
    LockstepBarrier * barrier;  ///< null outside lockstep
  };

  explicit Fleet(const Surroundings & surroundings);

  /// All or nothing, whatever is thrown.
  /// @throws Error for a car that cannot be used
  void add(
    const CarParameters & car, const CarDescription & description, const VehicleParameters & vehicle,
    const Pose2 & pose);
  void remove(CarId car);
  std::vector<DiagnosticsOutput::Driver> drivers() const;

private:
  struct Car
  {
    CarId id;
    CarParameters parameters;
    std::unique_ptr<CommandInput> commands;
  };

  CarOutputs makeOutputs(const Car & car);
  void addOdometry(const CarHandle & car, CarOutputs & outputs) const;
  void addPlugins(const Car & car, CarOutputs & outputs);
  void addCommands(Car & car);
  void removeFromWorld(CarId car);
  ros::NodeHandle nodeOf(const Car & car) const;

  const Surroundings around_;
  std::vector<std::unique_ptr<Car>> cars_;  // others refer to their commands
};
}  // namespace f1tenth_sim2d
