#include "sim2d_lockstep/done_ledger.h"

#include <algorithm>

#include "sim2d_lockstep/participant.h"

namespace sim2d_lockstep
{
bool isParticipant(const std::string & caller, const std::string & participant)
{
  const std::string node = "/" + participant;
  return caller == node || caller == node + kSecondHalf;
}

DoneLedger::DoneLedger(const std::vector<std::string> & names)
{
  for (const auto & name : names) {
    entries_.push_back({name, {}, {}});
  }
}

// A participant that acts less often than once per period answers each repetition of the first one in the same way; an
// answer to a run that is over comes once.
bool DoneLedger::believes(const Entry & entry, const ros::Time & stamp) const
{
  return entry.is_heard || stamp <= start_ || stamp >= kLeft || stamp == entry.doubtful;
}

void DoneLedger::note(const std::string & name, const ros::Time & stamp)
{
  for (auto & entry : entries_) {
    if (entry.name != name) {
      continue;
    }
    if (believes(entry, stamp)) {
      entry.done = stamp;
      entry.is_heard = entry.is_heard || stamp >= start_;
    } else {
      entry.doubtful = stamp;
    }
  }
}

bool DoneLedger::allDone(const ros::Time & stamp) const
{
  return std::all_of(
    entries_.begin(), entries_.end(), [&](const Entry & entry) { return entry.done && *entry.done >= stamp; });
}

std::vector<std::string> DoneLedger::missing(const ros::Time & stamp) const
{
  std::vector<std::string> names;
  for (const auto & entry : entries_) {
    if (!entry.done || *entry.done < stamp) {
      names.push_back(entry.name);
    }
  }
  return names;
}

void DoneLedger::startAgain(const ros::Time & stamp)
{
  start_ = stamp;
  for (auto & entry : entries_) {
    if (entry.done && *entry.done > stamp && *entry.done < kLeft) {
      entry.done.reset();
    }
    entry.is_heard = entry.done && *entry.done >= stamp;
    entry.doubtful.reset();
  }
}
}  // namespace sim2d_lockstep
