#pragma once

#include <memory>
#include <string>
#include <vector>

#include "car_outputs.h"
#include "f1tenth_sim2d/simulation.h"
#include "output.h"
#include "schedule.h"
#include "trajectory_log.h"
#include "transform_batch.h"

namespace f1tenth_sim2d
{
/// The simulation with all that happens along with it at fixed simulated times.
class SimulatedWorld
{
public:
  /// @param simulation  with all its cars
  /// @param transforms  published whenever tasks have run
  SimulatedWorld(
    Simulation & simulation, TransformBatch & transforms, double control_period_sec, const std::string & record_file);

  void addScan(CarIndex car, std::unique_ptr<ScanOutput> output);
  void addBumper(CarIndex car, std::unique_ptr<BumperOutput> output);
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
  void repeatScans(CarIndex car);
  void repeatOthers();
  /// Back to time 0, as from fresh.
  void restart();

private:
  void distributeContacts();
  void schedule(Output & output);

  Simulation & simulation_;
  TransformBatch & transforms_;
  const double period_ns_;
  Schedule schedule_;
  TrajectoryLog log_;
  std::vector<std::vector<std::unique_ptr<ScanOutput>>> scans_;      // by car
  std::vector<std::vector<std::unique_ptr<BumperOutput>>> bumpers_;  // by car
  std::vector<std::unique_ptr<Output>> others_;
};
}  // namespace f1tenth_sim2d
