#include "done_ledger.h"

#include <algorithm>

#include "sim2d_lockstep/participant.h"

namespace sim2d_lockstep
{
DoneLedger::DoneLedger(const std::vector<std::string> & names)
{
  for (const auto & name : names) {
    done_.emplace(name, std::nullopt);
  }
}

void DoneLedger::note(const std::string & name, const ros::Time & stamp)
{
  const auto entry = done_.find(name);
  if (entry != done_.end()) {
    entry->second = stamp;
  }
}

bool DoneLedger::allDone(const ros::Time & stamp) const
{
  return std::all_of(
    done_.begin(), done_.end(), [&](const auto & entry) { return entry.second && *entry.second >= stamp; });
}

void DoneLedger::startAgain(const ros::Time & stamp)
{
  for (auto & [name, done] : done_) {
    if (done && *done > stamp && *done < kLeft) {
      done.reset();
    }
  }
}
}  // namespace sim2d_lockstep
