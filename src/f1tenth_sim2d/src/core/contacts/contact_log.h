#pragma once

#include <algorithm>
#include <vector>

#include "core/contacts/step_contact.h"
#include "f1tenth_sim2d/simulation_types.h"

namespace f1tenth_sim2d
{
/// The contacts of one car since they were last cleared, one entry a pair of collision elements: the physics step in
/// which the pair pushed hardest, so that a bump shorter than a control period shows with its full force.
class ContactLog
{
public:
  const std::vector<Contact> & contacts() const { return contacts_; }
  void clear();
  /// A model has gone from the world, and those after it have moved up. Its contacts stay.
  void forgetModel(std::size_t index) noexcept;

  /// @param describe  fills in the names of a new contact
  /// @param dt        s, of the step in which `step` was recorded
  template <typename Describe>
  void add(const StepContact & step, double dt, Describe describe)
  {
    const std::size_t place = find(step);
    if (place == contacts_.size()) {
      contacts_.emplace_back();
      describe(step, contacts_.back());
    }
    contacts_[place].speed = std::max(contacts_[place].speed, step.speed);
    if (place == steps_.size() || strength(step) > strength(steps_[place])) {
      keep(place, step, dt);
    }
  }

private:
  static double strength(const StepContact & step)
  {
    return step.impulse.x * step.impulse.x + step.impulse.y * step.impulse.y;
  }
  std::size_t find(const StepContact & step) const;
  void keep(std::size_t place, const StepContact & step, double dt);

  std::vector<StepContact> steps_;  ///< parallel to contacts_
  std::vector<Contact> contacts_;
};
}  // namespace f1tenth_sim2d
