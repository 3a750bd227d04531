#include "core/contacts/contact_log.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
constexpr auto kGone = std::numeric_limits<std::uint32_t>::max();  // in place of the index of a model
}  // namespace

void ContactLog::clear()
{
  steps_.clear();
  contacts_.clear();
}

void ContactLog::forgetModel(std::size_t index) noexcept
{
  for (StepContact & step : steps_) {
    if (step.other_owner != Piece::Owner::kModel || step.other_body == kGone || step.other_body < index) {
      continue;
    }
    step.other_body = step.other_body == index ? kGone : step.other_body - 1;
  }
}

void ContactLog::add(const StepContact & step, const Contact & contact)
{
  const auto found =
    std::find_if(steps_.begin(), steps_.end(), [&](const StepContact & kept) { return kept.isOfSamePair(step); });
  if (found == steps_.end()) {
    steps_.push_back(step);
    contacts_.push_back(contact);
    return;
  }
  Contact & kept = contacts_[found - steps_.begin()];
  const double speed = std::max(kept.speed, contact.speed);
  if (dot(step.impulse, step.impulse) > dot(found->impulse, found->impulse)) {
    *found = step;
    kept = contact;
  }
  kept.speed = speed;
}
}  // namespace f1tenth_sim2d
