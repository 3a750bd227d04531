#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation/trajectory_log.h"
#include "f1tenth_sim2d/simulation.h"
#include "node/messages/output.h"
#include "node/messages/transform_batch.h"
#include "node/world/schedule.h"

namespace f1tenth_sim2d
{
/// The simulation with everything that happens in it at fixed simulated times.
class SimulatedWorld
{
public:
  /// @param simulation  without cars
  /// @param transforms  published whenever tasks have run
  SimulatedWorld(
    Simulation & simulation, TransformBatch & transforms, double control_period_sec, const std::string & record_file);

  using OutputsId = int;
  /// Runs outputs at their rates until remove(); see RunningOutputs.
  /// @param car  whose they are: they are told of its contacts
  OutputsId add(const OutputList & outputs, std::optional<CarId> car);
  void remove(OutputsId id);
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
  /// To the end of the control period under way, unless one has just ended.
  void finishPeriod();
  /// Runs the outputs of a car now that have not run since it was added.
  void measureFirst(CarId car);
  /// Whether the driver of a car has had something to answer since a time; also true if it never has.
  bool isToAnswer(CarId car, SimTime since) const;
  /// Publishes the last messages again: what the driver of one car answers, or everything else.
  void repeatForDriver(CarId car);
  void repeatOthers();
  /// Back to time 0, as if built anew.
  void restart();
  /// Cars and models back to where they started; time goes on.
  void resetPoses();

private:
  struct Running
  {
    const OutputList & outputs;
    std::optional<CarId> car;
    SimTime since;  ///< when they were added
    std::vector<Schedule::Id> tasks;
  };

  template <typename Visit>
  void forEachOutput(Visit visit);
  SimTime endOf(std::int64_t period) const;
  void update(Output & output, std::optional<CarId> car, bool anyway);
  void distributeContacts();
  void forgetContacts();
  Schedule::Id schedule(Output & output, std::optional<CarId> car);

  Simulation & simulation_;
  TransformBatch & transforms_;
  const double period_ns_;
  Schedule schedule_;
  TrajectoryLog log_;
  std::map<OutputsId, Running> running_;
  std::map<CarId, SimTime> answered_at_;  // of the last output that the driver of a car answers
  OutputsId next_id_{0};
};

/// Outputs that the world runs as long as this exists.
class RunningOutputs
{
public:
  /// @param car  whose they are: they are told of its contacts
  RunningOutputs(SimulatedWorld & world, OutputList outputs, std::optional<CarId> car = std::nullopt)
  : world_(world), outputs_(std::move(outputs)), id_(world_.add(outputs_, car))
  {
  }
  ~RunningOutputs() { world_.remove(id_); }
  RunningOutputs(const RunningOutputs &) = delete;
  RunningOutputs & operator=(const RunningOutputs &) = delete;

private:
  SimulatedWorld & world_;
  const OutputList outputs_;
  const SimulatedWorld::OutputsId id_;
};
}  // namespace f1tenth_sim2d
