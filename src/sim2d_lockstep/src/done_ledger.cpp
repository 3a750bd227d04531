#include "sim2d_lockstep/done_ledger.h"

#include <algorithm>

#include "sim2d_lockstep/participant.h"

namespace sim2d_lockstep
{
DoneLedger::DoneLedger(const std::vector<std::string> & names)
{
  for (const auto & name : names) {
    done_.emplace_back(name, std::nullopt);
  }
}

void DoneLedger::note(const std::string & name, const ros::Time & stamp)
{
  for (auto & [known, done] : done_) {
    if (known == name) {
      done = stamp;
    }
  }
}

bool DoneLedger::allDone(const ros::Time & stamp) const
{
  return std::all_of(
    done_.begin(), done_.end(), [&](const auto & entry) { return entry.second && *entry.second >= stamp; });
}

std::vector<std::string> DoneLedger::missing(const ros::Time & stamp) const
{
  std::vector<std::string> names;
  for (const auto & [name, done] : done_) {
    if (!done || *done < stamp) {
      names.push_back(name);
    }
  }
  return names;
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
