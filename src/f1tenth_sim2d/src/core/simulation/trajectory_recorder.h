#pragma once

#include <fstream>
#include <map>
#include <set>
#include <string>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What a car touched.
struct Touch
{
  std::set<std::string> models;  ///< their names
  double speed{0.0};             ///< m/s, as in Contact: the greatest
};

/// For cars that touched anything.
using Touches = std::map<CarId, Touch>;

/// Writes one CSV row a car and control period, with all digits of every number. Columns: docs/contracts.md.
class TrajectoryRecorder
{
public:
  /// @throws Error if the file cannot be written
  explicit TrajectoryRecorder(const std::string & file);

  /// @param touches  in the period
  void write(const Simulation & simulation, const Touches & touches, const std::string & hash);
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
