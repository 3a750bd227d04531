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
  forgetTouches();
}

void TrajectoryLog::restart()
{
  hash_.reset();
  periods_ = 0;
  forgetTouches();
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

void TrajectoryLog::forgetTouches()
{
  for (auto & models : touched_) {
    models.clear();
  }
}
}  // namespace f1tenth_sim2d
