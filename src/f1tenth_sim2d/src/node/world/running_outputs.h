#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "node/messages/output.h"
#include "node/world/simulated_world.h"

namespace f1tenth_sim2d
{
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
