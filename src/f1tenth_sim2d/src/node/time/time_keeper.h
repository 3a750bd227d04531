#pragma once

#include <functional>

namespace f1tenth_sim2d
{
/// Lets simulated time advance, and serves the node's callbacks in between: one of the three ways of docs/contracts.md.
class TimeKeeper
{
public:
  virtual ~TimeKeeper() = default;
  /// Advances to the next simulated time at which something happens. Blocks for 0.1 s of wall time at a time at most
  /// while it waits, then looks whether to stop.
  virtual void advance() = 0;
  /// After a pause, or when simulated time has gone back to 0.
  virtual void restart() {}
};

/// What others may do to the flow of time; all on the simulation's thread.
struct TimeControl
{
  bool paused{false};
  bool is_lockstep{false};
  double real_time_factor{1.0};  ///< 0, and in lockstep: as fast as possible
  int restarts{0};               ///< how often simulated time has gone back to 0
  int pauses{0};                 ///< how often it has gone on after a pause
};
}  // namespace f1tenth_sim2d
