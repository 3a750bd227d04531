#include "loaders/xml/warning_collector.h"

#include <algorithm>

namespace f1tenth_sim2d
{
void WarningCollector::add(const std::string & kind, const std::string & place)
{
  const auto known =
    std::find_if(entries_.begin(), entries_.end(), [&](const Entry & entry) { return entry.kind == kind; });
  if (known == entries_.end()) {
    entries_.push_back({kind, place, 0});
  } else {
    ++known->more;
  }
}

std::vector<std::string> WarningCollector::messages() const
{
  std::vector<std::string> messages;
  for (const Entry & entry : entries_) {
    const std::string others = entry.more == 0 ? "" : " and " + std::to_string(entry.more) + " more";
    messages.push_back(entry.first_place + others + ": " + entry.kind);
  }
  return messages;
}
}  // namespace f1tenth_sim2d
