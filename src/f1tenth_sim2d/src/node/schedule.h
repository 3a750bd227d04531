#pragma once

#include <functional>
#include <string>
#include <vector>

#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
/// What happens at fixed rates of simulated time. The n-th time of a task is n periods after the start, rounded to the
/// nanosecond, so that no rate drifts. Tasks that are due at the same time run in the order in which they were added.
class Schedule
{
public:
  using Task = std::function<void(SimTime now)>;

  /// @param period_ns may have a fraction; > 0
  void add(double period_ns, Task task);
  /// Time of the task that comes next, ns.
  SimTime nextDue() const;
  /// Runs every task that is due at now, once.
  void run(SimTime now);
  /// Back to time 0.
  void restart();

private:
  struct Entry
  {
    double period_ns;
    Task task;
    std::int64_t count;  ///< of the time that comes next
    SimTime due() const;
  };
  std::vector<Entry> entries_;
};

/// Period of a rate in Hz, ns.
double periodOf(double rate_hz);
}  // namespace f1tenth_sim2d
