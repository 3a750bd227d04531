#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "node/time/lockstep_barrier.h"

namespace f1tenth_sim2d
{
/// How a run ended; the content of the result file (docs/contracts.md).
struct RunResult
{
  std::string reason;       ///< "requested", "bad_input", "participant_silent" or "internal_error"
  std::string error;        ///< the one line; empty if it ended by request
  std::string participant;  ///< that fell silent
  double sim_time_sec{0.0};
  double wall_time_sec{0.0};        ///< from the first step on
  std::int64_t periods{0};          ///< control periods
  std::vector<StrayAnswer> strays;  ///< in lockstep; with one the run cannot be repeated
  std::string trajectory_hash;      ///< empty if there was no run
  std::uint64_t seed{0};
  double physics_step_sec{0.0};
  std::string world_sha256;                        ///< of the world's file
  std::map<std::string, std::string> cars_sha256;  ///< by car: of its robot_description and its vehicle file
};

/// Writes JSON to a temporary file beside the file, then renames it, so that nobody ever reads half a result.
/// @throws Error if the file cannot be written
void writeResult(const std::string & file, const RunResult & result);
}  // namespace f1tenth_sim2d
