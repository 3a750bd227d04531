#include "node/time/stop_signal.h"

#include <ros/init.h>

#include <csignal>

namespace f1tenth_sim2d
{
namespace
{
volatile std::sig_atomic_t stop_requested = 0;

void requestStop(int /*signal*/)
{
  stop_requested = 1;
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}
}  // namespace

void handleStopSignals()
{
  std::signal(SIGINT, &requestStop);
  std::signal(SIGTERM, &requestStop);
}

bool stopRequested()
{
  return stop_requested != 0 || !ros::ok();
}
}  // namespace f1tenth_sim2d
