#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "f1tenth_sim2d/simulation.h"
#include "f1tenth_sim2d/trajectory_hash.h"

namespace f1tenth_sim2d
{
/// What is kept of a run, control period by control period: the hash, and the record if there is one. That is a CSV
/// file with one row per car and period, with all digits of every number, complete after each period for who reads it
/// meanwhile. Columns: docs/contracts.md.
class TrajectoryLog
{
public:
  /// @param record_file  empty: none
  /// @throws Error if it cannot be written, as do all functions that write
  TrajectoryLog(const Simulation & simulation, const std::string & record_file);

  /// To be called for every contact, once, in the period in which it happens.
  void note(CarId car, const Contact & contact);
  void endPeriod();
  /// Begins anew. The record so far, with what was touched since its last period, is kept as FILE.before_reset_1, _2, ...
  void restart();

  std::int64_t periods() const { return periods_; }
  std::string hash() const { return hash_.hexDigest(); }

private:
  /// What a car touched in this period.
  struct Touch
  {
    std::set<std::string> models;  ///< their names
    double speed{0.0};             ///< m/s, as in Contact: the greatest
  };

  void beginRecord();
  void keepRecord();
  void writeRecord();
  void requireGood() const;

  const Simulation & simulation_;
  const std::string record_file_;
  std::ofstream record_;
  TrajectoryHash hash_;
  std::map<CarId, Touch> touches_;  ///< of cars that touched anything
  std::int64_t periods_{0};
  int restarts_{0};
};
}  // namespace f1tenth_sim2d
