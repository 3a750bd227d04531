#include "node/time/continuous_time.h"

#include <algorithm>

#include "node/time/stop_signal.h"

namespace f1tenth_sim2d
{
namespace
{
const ros::WallDuration kStopCheck{0.1};
}  // namespace

void FreeTime::advance()
{
  queue_.callAvailable();
  if (!stopRequested() && !control_.paused) {
    world_.advanceTo(world_.periodEnd());
    drain_.drain();
  }
}

PacedTime::PacedTime(SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control)
: world_(world), queue_(queue), control_(control), pacer_(control.real_time_factor)
{
  restart();
}

void PacedTime::restart()
{
  pacer_.start(world_.time(), ros::WallTime::now());
}

void PacedTime::advance()
{
  const SimTime next = world_.nextDue();
  if (serveCallbacksUntilDue(next)) {
    world_.advanceTo(next);
  }
}

bool PacedTime::serveCallbacksUntilDue(SimTime next)
{
  const int restarts = control_.restarts;
  const double factor = control_.real_time_factor;
  const auto interrupted = [&] {
    return stopRequested() || control_.paused || control_.restarts != restarts || control_.real_time_factor != factor;
  };
  const ros::WallTime due = pacer_.due(next, ros::WallTime::now());
  queue_.callAvailable();
  for (auto now = ros::WallTime::now(); now < due && !interrupted(); now = ros::WallTime::now()) {
    queue_.callAvailable(std::min(due - now, kStopCheck));
  }
  return !interrupted();
}
}  // namespace f1tenth_sim2d
