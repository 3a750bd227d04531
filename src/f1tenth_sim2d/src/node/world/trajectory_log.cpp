#include "node/world/trajectory_log.h"

namespace f1tenth_sim2d
{
TrajectoryLog::TrajectoryLog(const Simulation & simulation, const std::string & record_file) : simulation_(simulation)
{
  if (!record_file.empty()) {
    recorder_.emplace(record_file);
  }
}

void TrajectoryLog::endPeriod()
{
  hash_.add(simulation_);
  ++periods_;
  if (recorder_) {
    recorder_->write(simulation_, touched_, hash_.hexDigest());
  }
  touched_.clear();
}

void TrajectoryLog::restart()
{
  hash_.reset();
  periods_ = 0;
  touched_.clear();
  if (recorder_) {
    recorder_->restart();
  }
}

void TrajectoryLog::flush()
{
  if (recorder_) {
    recorder_->flush();
  }
}

}  // namespace f1tenth_sim2d
