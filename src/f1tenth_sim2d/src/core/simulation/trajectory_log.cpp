#include "core/simulation/trajectory_log.h"

#include <algorithm>

namespace f1tenth_sim2d
{
TrajectoryLog::TrajectoryLog(const Simulation & simulation, const std::string & record_file) : simulation_(simulation)
{
  if (!record_file.empty()) {
    recorder_.emplace(record_file);
  }
}

void TrajectoryLog::note(CarId car, const Contact & contact)
{
  Touch & touch = touches_[car];
  touch.models.insert(contact.other_model);
  touch.speed = std::max(touch.speed, contact.speed);
}

void TrajectoryLog::endPeriod()
{
  hash_.add(simulation_);
  ++periods_;
  if (recorder_) {
    recorder_->write(simulation_, touches_, hash_.hexDigest());
  }
  touches_.clear();
}

void TrajectoryLog::restart()
{
  hash_.reset();
  periods_ = 0;
  touches_.clear();
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
