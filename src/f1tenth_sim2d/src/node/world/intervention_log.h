#pragma once

#include <fstream>
#include <string>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What somebody outside did to the running simulation.
struct Intervention
{
  std::string kind;    ///< the service or topic of gazebo_ros: "set_model_state"
  std::string caller;  ///< name of the ROS node
  std::string model;   ///< empty: the whole world
};

/// Every intervention of a run, one JSON object a line: time (s), kind, caller, model. A line is in the file before the
/// intervention has any effect.
class InterventionLog
{
public:
  /// @param file  begun anew; empty: none
  /// @throws Error if it cannot be written, as does add()
  explicit InterventionLog(const std::string & file);

  void add(SimTime time, const Intervention & intervention);

private:
  void requireGood() const;

  const std::string file_;
  std::ofstream stream_;
};
}  // namespace f1tenth_sim2d
