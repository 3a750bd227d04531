#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"
#include "node/cars/car_outputs.h"
#include "node/messages/output.h"
#include "node/messages/transform_batch.h"
#include "node/world/schedule.h"
#include "node/world/trajectory_log.h"

namespace f1tenth_sim2d
{
/// What a car publishes.
struct CarOutputs
{
  std::vector<std::unique_ptr<ScanOutput>> scans;
  std::vector<std::unique_ptr<BumperOutput>> bumpers;
  std::vector<std::unique_ptr<Output>> others;
};

/// The simulation with all that happens along with it at fixed simulated times.
class SimulatedWorld
{
public:
  /// @param simulation  without cars
  /// @param transforms  published whenever tasks have run
  SimulatedWorld(
    Simulation & simulation, TransformBatch & transforms, double control_period_sec, const std::string & record_file);

  /// Outputs of a car that has just been added to the simulation, and the end of them, if there are any.
  void addCar(CarId car, CarOutputs outputs);
  void removeCar(CarId car);
  void add(std::unique_ptr<Output> output);
  /// For what is not an Output. Tasks run after all outputs that were added before.
  Schedule & schedule() { return schedule_; }

  SimTime time() const { return simulation_.time(); }
  SimTime nextDue() const { return schedule_.nextDue(); }
  /// End of the control period under way, ns.
  SimTime periodEnd() const;
  std::int64_t periods() const { return log_.periods(); }
  std::string hash() const { return log_.hash(); }

  /// Steps, and runs everything that falls due on the way.
  void advanceTo(SimTime end);
  /// Publishes the last messages again: of one car's lidars, or of everything else.
  void repeatScans(CarId car);
  void repeatOthers();
  /// Back to time 0, as from fresh.
  void restart();
  /// Cars and models back to where they started; time goes on.
  void resetPoses();
  void flushRecord() { log_.flush(); }

private:
  void distributeContacts();
  void forgetContacts();
  Schedule::Id schedule(Output & output);

  Simulation & simulation_;
  TransformBatch & transforms_;
  const double period_ns_;
  Schedule schedule_;
  TrajectoryLog log_;
  struct Car
  {
    CarOutputs outputs;
    std::vector<Schedule::Id> tasks;
  };
  std::map<CarId, Car> cars_;
  std::vector<std::unique_ptr<Output>> others_;
};
}  // namespace f1tenth_sim2d
