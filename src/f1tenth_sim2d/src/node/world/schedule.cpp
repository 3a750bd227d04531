#include "node/world/schedule.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
constexpr double kShortest = 1.0;  // ns: time is counted in them
constexpr double kNever = 9e18;    // ns: no SimTime is much later
}  // namespace

SimTime Schedule::Entry::due() const
{
  const double due_ns = static_cast<double>(count) * period_ns;
  return due_ns < kNever ? std::llround(due_ns) : std::numeric_limits<SimTime>::max();
}

void Schedule::Entry::passOver(SimTime now)
{
  // The division may be off by one because of rounding.
  count = std::max(count, static_cast<std::int64_t>(static_cast<double>(now) / period_ns) - 1);
  while (due() <= now) {
    ++count;
  }
}

Schedule::Id Schedule::add(double period_ns, Task task, SimTime now)
{
  assert(period_ns > 0.0);
  Entry & entry = entries_.emplace_back(Entry{next_id_++, std::max(period_ns, kShortest), std::move(task), 1});
  entry.passOver(now);
  return entry.id;
}

void Schedule::remove(Id id)
{
  const auto end =
    std::remove_if(entries_.begin(), entries_.end(), [id](const Entry & entry) { return entry.id == id; });
  entries_.erase(end, entries_.end());
}

SimTime Schedule::nextDue() const
{
  SimTime next = std::numeric_limits<SimTime>::max();
  for (const auto & entry : entries_) {
    next = std::min(next, entry.due());
  }
  return next;
}

void Schedule::run(SimTime now)
{
  for (auto & entry : entries_) {
    if (entry.due() <= now) {
      // A rate above that of the physics steps cannot be kept: one run stands for all that have passed.
      entry.passOver(now);
      entry.task(now);
    }
  }
}

void Schedule::restart()
{
  for (auto & entry : entries_) {
    entry.count = 1;
  }
}

double periodOf(double rate_hz)
{
  return 1e9 / rate_hz;
}
}  // namespace f1tenth_sim2d
