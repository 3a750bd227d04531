#pragma once

#include <optional>
#include <string>

#include "core/simulation/trajectory_recorder.h"
#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/trajectory_hash.h"

namespace f1tenth_sim2d
{
/// What is kept of a run, control period by control period: the hash, and the record if there is one.
class TrajectoryLog
{
public:
  /// @param record_file  empty: none
  /// @throws Error if it cannot be written
  TrajectoryLog(const Simulation & simulation, const std::string & record_file);

  /// Every contact, once, in the period in which it was.
  void note(CarId car, const Contact & contact);
  void endPeriod();
  void restart();
  /// Leaves nothing of the record in memory.
  void flush();

  std::int64_t periods() const { return periods_; }
  std::string hash() const { return hash_.hexDigest(); }

private:
  const Simulation & simulation_;
  TrajectoryHash hash_;
  std::optional<TrajectoryRecorder> recorder_;
  Touches touches_;
  std::int64_t periods_{0};
};
}  // namespace f1tenth_sim2d
