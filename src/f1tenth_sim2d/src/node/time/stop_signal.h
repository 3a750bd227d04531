#pragma once

namespace f1tenth_sim2d
{
/// SIGINT and SIGTERM ask for the end of the run; the second one ends the process at once.
void handleStopSignals();

/// Whether somebody has asked for the end: by signal or through ROS.
bool stopRequested();
}  // namespace f1tenth_sim2d
