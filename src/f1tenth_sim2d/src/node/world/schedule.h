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

  using Id = int;

  /// @param period_ns may have a fraction; > 0
  /// @param now  the first time is the first multiple of the period after it
  Id add(double period_ns, Task task, SimTime now = 0);
  void remove(Id id);
  /// Time of the task that comes next, ns.
  SimTime nextDue() const;
  /// Runs every task that is due at now, once.
  void run(SimTime now);
  /// Back to time 0.
  void restart();

private:
  struct Entry
  {
    Id id;
    double period_ns;
    Task task;
    std::int64_t count;  ///< of the time that comes next
    SimTime due() const;
    void passOver(SimTime now);
  };
  std::vector<Entry> entries_;
  Id next_id_{0};
};

/// Period of a rate in Hz, ns.
double periodOf(double rate_hz);
}  // namespace f1tenth_sim2d
