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
  const int restarts = control_.restarts;
  const auto interrupted = [&] { return stopRequested() || control_.paused || control_.restarts != restarts; };
  queue_.callAvailable();
  flow_.waitForSubscribers(interrupted);
  if (!interrupted()) {
    world_.advanceTo(world_.periodEnd());
  }
}

PacedTime::PacedTime(
  SimulatedWorld & world, ros::CallbackQueue & queue, const TimeControl & control, FlowControl & flow)
: world_(world), queue_(queue), control_(control), flow_(flow), pacer_(control.real_time_factor)
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
    flow_.waitForSubscribers([] { return false; });
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
