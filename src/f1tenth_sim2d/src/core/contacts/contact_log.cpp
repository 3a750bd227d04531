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

std::size_t ContactLog::find(const StepContact & step) const
{
  const auto found =
    std::find_if(steps_.begin(), steps_.end(), [&](const StepContact & kept) { return kept.isOfSamePair(step); });
  return found - steps_.begin();
}

void ContactLog::keep(std::size_t place, const StepContact & step, double dt)
{
  steps_.resize(contacts_.size());
  steps_[place] = step;
  Contact & contact = contacts_[place];
  contact.positions = step.positions;
  contact.normals = step.normals;
  contact.depths = step.depths;
  contact.force = {step.impulse.x / dt, step.impulse.y / dt};
  contact.torque = step.angular_impulse / dt;
}
}  // namespace f1tenth_sim2d
