#pragma once

#include <fstream>
#include <map>
#include <set>
#include <string>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// The names of the models that a car touched, for cars that touched any.
using TouchedModels = std::map<CarId, std::set<std::string>>;

/// Writes one CSV row a car and control period, with all digits of every number. Columns: docs/contracts.md.
class TrajectoryRecorder
{
public:
  /// @throws Error if the file cannot be written
  explicit TrajectoryRecorder(const std::string & file);

  /// @param touched  in the period
  void write(const Simulation & simulation, const TouchedModels & touched, const std::string & hash);
  /// Begins the file anew.
  void restart();
  /// Leaves nothing in memory.
  /// @throws Error if the file cannot be written
  void flush();

private:
  void open();
  void requireGood() const;

  const std::string file_;
  std::ofstream stream_;
};
}  // namespace f1tenth_sim2d
